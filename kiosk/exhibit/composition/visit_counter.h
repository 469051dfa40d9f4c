#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/exhibit/composition/keepsakes.h"
#include "kiosk/keepsake/store/store_thread.h"
#include "kiosk/visit/screens/visit_notes.h"

namespace onggi::exhibit {

/// Has visits counted: what the screens noted, with the names of things and the time of day. A
/// visit whose keepsake is still being saved waits for it. Main thread; no call but
/// finish() waits for a disk.
class VisitCounter {
 public:
  /// `fetched`: where phones' fetches are noted (souvenir::Passes::fetched()); "": nowhere.
  VisitCounter(const std::filesystem::path& file, const settings::Exhibit& exhibit,
               const std::filesystem::path& fetched = {});

  /// `vessel`: its name on the shelf, "" where none was chosen. `ticket`: of the visitor's last
  /// save; 0: nothing was to be kept.
  void visit_over(const screens::VisitNotes& notes, const std::string& vessel, int ticket);
  /// A save has ended, before its visit did or after.
  void saved(const Keepsakes::Finished& save);
  /// The end: counts visits whose keepsakes never came without them, and waits for the disk. How
  /// many it did not take is among remarks(). Nothing is counted after it.
  void finish();
  /// What staff should know, once.
  std::vector<Problem> remarks() { return store_.remarks(); }

 private:
  std::string scene_of(const std::string& vessel) const;

  std::string scene_;
  std::map<std::string, std::string> vessel_scenes_;
  std::map<int, bool> saved_;                  ///< By ticket: whether it was kept.
  std::map<int, store::VisitRecord> waiting_;  ///< Likewise: visits that are over.
  store::StoreThread store_;
};

}  // namespace onggi::exhibit
