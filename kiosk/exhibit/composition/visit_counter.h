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

/// Records visits: the screens' notes, with names and the time of day. A visit whose keepsake is
/// still being saved waits for that. Main thread; only finish() waits for a disk.
class VisitCounter {
 public:
  /// `fetched`: folder of phones' notes (souvenir::Passes::fetched()); "": none.
  VisitCounter(const std::filesystem::path& file, const settings::Exhibit& exhibit,
               const std::filesystem::path& fetched = {});

  /// `vessel`: its id on the shelf, "" if none was chosen. `ticket`: the visitor's last save; 0:
  /// none.
  void visit_over(const screens::VisitNotes& notes, const std::string& vessel, int ticket);
  /// A save has ended, before or after its visit.
  void saved(const Keepsakes::Finished& save);
  /// The end: counts visits still waiting as without a keepsake, and waits for the disk. remarks()
  /// then tells how many the disk refused. Add nothing after it.
  void finish();
  /// Messages for staff, each once.
  std::vector<Problem> remarks() { return store_.remarks(); }

 private:
  std::string scene_of(const std::string& vessel, bool built) const;

  std::string scene_;
  std::map<std::string, std::string> vessel_scenes_;
  std::string built_scene_;
  std::map<int, bool> saved_;                  ///< By ticket: whether the keepsake was saved.
  std::map<int, store::VisitRecord> waiting_;  ///< By ticket: visits that are over.
  store::StoreThread store_;
};

}  // namespace onggi::exhibit
