#pragma once

#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "kiosk/collection/content/vessel.h"

namespace onggi::content {

/// A shelf: the vessels that loaded, and the others with the reason. Never throws; a broken pack is
/// left off.
struct Catalogue {
  std::vector<Vessel> vessels;
  std::vector<Problem> problems;
  const Vessel* find(const std::string& id) const;
};

/// Receives each entry of a shelf as it is read, from any thread but one call at a time.
class ShelfWatcher {
 public:
  virtual ~ShelfWatcher() = default;
  /// Entry `at` of `total`, sorted by id, is about to be read.
  virtual void begins(std::size_t at, std::size_t total, const std::string& id) = 0;
  /// Its vessels, or why it cannot be used.
  virtual void has_read(std::size_t at, Result<std::vector<Vessel>> read) = 0;
};

/// Reads a folder's entries on as many threads as there are processors, and tells `watcher` about
/// each. Problem if the folder cannot be listed.
Result<void> read_shelf(const std::filesystem::path& folder, ShelfWatcher& watcher,
                        const settings::ReaderLimits& limits = {});

/// Opens a folder: `<id>/{vessel.glb,vessel.toml}` packs, and loose .glb/.gltf files (also one
/// folder down). A file of several objects that stand apart brings each that is a vessel. Sorted by
/// id. Reads on as many threads as there are processors. `progress(done, total, name)` is called
/// before each, if given, from any of them but one at a time.
Catalogue open_shelf(const std::filesystem::path& folder,
                     void (*progress)(int, int, const std::string&, void*) = nullptr,
                     void* user = nullptr, const settings::ReaderLimits& limits = {});

/// What check_shelf() checked, and everything wrong with it, including faults that the kiosk
/// tolerates, such as a label of more than 100 words or a size that contradicts the drawing.
struct ShelfCheck {
  std::vector<Problem> problems;
  std::vector<std::string> ids;              ///< Of the vessels, good or not.
  std::vector<std::filesystem::path> files;  ///< Each that was read, in order.
  int keys_checked = 0;
};

/// Checks a shelf, one pack, or one GLB/glTF file. Labels must exist in `languages` (read_pack()).
/// After a `stop`, it skips the remaining vessels.
ShelfCheck check_shelf(const std::filesystem::path& path, const settings::ReaderLimits& limits = {},
                       const std::vector<std::string>& languages = {}, std::stop_token stop = {});

}  // namespace onggi::content
