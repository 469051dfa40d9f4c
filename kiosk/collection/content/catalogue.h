#pragma once

#include <cstddef>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

#include "kiosk/collection/content/vessel.h"
#include "kiosk/collection/settings/translations.h"

namespace onggi::content {

/// The most vessels on a shelf: with more, one frame measures labels for over half a second.
inline constexpr std::size_t kMostOnShelf = 500;

/// Receives each entry of a shelf as it is read, from any thread but one call at a time.
class ShelfWatcher {
 public:
  virtual ~ShelfWatcher() = default;
  /// Entry `at` of `total`, in the order of the shelf, is about to be read.
  virtual void begins(std::size_t at, std::size_t total, const std::string& id) = 0;
  /// Its vessels, or why it cannot be used.
  virtual void has_read(std::size_t at, Result<std::vector<Vessel>> read) = 0;
};

/// Which vessels of a shelf visitors see, and in which order. Ids that are not there do nothing.
struct Arrangement {
  std::vector<std::string> order;   ///< These stand first; the others follow, sorted by id.
  std::vector<std::string> hidden;  ///< These are not read; hidden wins over order.
};

/// Opens a folder: `<id>/{vessel.glb,vessel.toml}` packs, and loose .glb/.gltf files (also one
/// folder down). A file of several objects that stand apart brings each that is a vessel. Reads on
/// as many threads as there are processors, for the screen (LoadOptions::for_screen), and tells
/// `watcher` about each entry, of the first kMostOnShelf by name; a broken one is a Problem of its
/// own. Problem if the folder cannot be listed.
Result<void> read_shelf(const std::filesystem::path& folder, ShelfWatcher& watcher,
                        const settings::ReaderLimits& limits = {},
                        const Arrangement& arrangement = {});

/// What check_shelf() checked, and everything wrong with it, including faults that the kiosk
/// tolerates, such as a label of more than 100 words or a size that contradicts the drawing.
struct ShelfCheck {
  std::vector<Problem> problems;
  std::vector<std::string> ids;              ///< Of the vessels, good or not, in their order.
  std::vector<std::string> hidden;           ///< Ids of those that visitors do not see.
  std::vector<Problem> notes;                ///< A line for each unfinished vessel.
  std::vector<std::filesystem::path> files;  ///< Each that was read, in order.
  int keys_checked = 0;
};

/// Checks a shelf, one pack, or one GLB/glTF file. Labels must exist in `languages` (read_pack()),
/// or their titles in `translations`. Hidden vessels are not checked. What an unfinished vessel of
/// a shelf lacks is counted in a note; checked alone, it is told. After a `stop`, it skips the
/// remaining vessels.
ShelfCheck check_shelf(const std::filesystem::path& path, const settings::ReaderLimits& limits = {},
                       const std::vector<std::string>& languages = {}, std::stop_token stop = {},
                       const settings::Translations& translations = {},
                       const Arrangement& arrangement = {});

}  // namespace onggi::content
