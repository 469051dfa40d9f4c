#include "kiosk/collection/settings/keepsake_place.h"

#include <algorithm>
#include <vector>

#include "kiosk/ground/files/paths.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;

fs::path real(const fs::path& path) {
  std::error_code error;
  fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) found = path.lexically_normal();
  return found.has_filename() ? found : found.parent_path();
}

/// `inner` is `outer` or lies in it; both real.
bool is_within(const fs::path& inner, const fs::path& outer) {
  const auto apart = std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end());
  return apart.first == outer.end();
}

/// Why no folder `path` can be made; "" if one can, as far as names tell.
std::string impossible(const fs::path& path) {
  constexpr std::size_t kLongestName = 255,
                        kLongestPath = 3800;  // bytes; a visit's files lie below
  if (path.string().size() > kLongestPath) return "The folder's path is too long.";
  fs::path up;
  for (const fs::path& part : path) {
    if (part.string().size() > kLongestName)
      return "A folder in this path has a name of " + std::to_string(part.string().size()) +
             " bytes, but only 255 are possible.";
    up /= part;
    std::error_code error;
    const auto kind = fs::status(up, error).type();
    if (kind != fs::file_type::directory && kind != fs::file_type::not_found &&
        kind != fs::file_type::none && up != path)
      return up.string() + " is a file, so no folder can lie in it.";
  }
  return "";
}

}  // namespace

void check_keepsake_place(toml::TomlReader::Table keepsake, const Exhibit& exhibit,
                          const fs::path& language_folder) {
  const std::string remedy = "Name a folder of its own, such as folder = \"../keepsakes\".";
  if (const std::string why = impossible(exhibit.keepsake.folder); !why.empty())
    return keepsake.complain("folder", why, remedy);
  const fs::path keeps = real(exhibit.keepsake.folder), shelf = real(exhibit.shelf);
  std::vector<fs::path> content{shelf};
  if (!language_folder.empty()) content.push_back(real(language_folder));
  // A site is copied whole as the last good exhibit: config/ and content/.
  const fs::path site = real(exhibit.file).parent_path().parent_path();
  if (const fs::path own = files::site_exhibit(exhibit.file);
      !own.empty() && real(own) == real(exhibit.file)) {
    content.push_back(site / "config");
    content.push_back(site / "content");
  }
  for (const fs::path& folder : content)
    if (is_within(keeps, real(folder)))
      return keepsake.complain(
          "folder",
          "The keepsakes would lie in " + folder.string() + ", among what the museum shows.",
          remedy);
  if (is_within(shelf, keeps))
    keepsake.complain(
        "folder", "The shelf " + shelf.string() + " lies in the folder of the keepsakes.", remedy);
}

}  // namespace onggi::settings
