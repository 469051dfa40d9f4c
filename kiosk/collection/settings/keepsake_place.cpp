#include "kiosk/collection/settings/keepsake_place.h"

#include <algorithm>
#include <vector>

#include "kiosk/ground/files/paths.h"

namespace onggi::settings {
namespace {

namespace fs = std::filesystem;

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
    if (error == std::errc::too_many_symbolic_link_levels)
      return up.string() + " is a link that leads back to itself.";
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
  const fs::path& keeps = exhibit.keepsake.folder;
  for (const char* system : {"/proc", "/sys", "/dev"})
    if (files::is_within(keeps, system))
      return keepsake.complain(
          "folder", std::string(system) + " is the system's own: no file stays there.", remedy);
  std::vector<fs::path> content{exhibit.shelf};
  if (!language_folder.empty()) content.push_back(language_folder);
  // A site is copied whole as the last good exhibit: config/ and content/.
  const fs::path site = files::real_path(exhibit.file).parent_path().parent_path();
  if (const fs::path own = files::site_exhibit(exhibit.file);
      !own.empty() && files::real_path(own) == files::real_path(exhibit.file)) {
    content.push_back(site / "config");
    content.push_back(site / "content");
  }
  for (const fs::path& folder : content)
    if (files::is_within(keeps, folder))
      return keepsake.complain("folder",
                               "The keepsakes would lie in " + files::real_path(folder).string() +
                                   ", among what the museum shows.",
                               remedy);
  if (files::is_within(exhibit.shelf, keeps))
    keepsake.complain("folder",
                      "The shelf " + files::real_path(exhibit.shelf).string() +
                          " lies in the folder of the keepsakes.",
                      remedy);
}

}  // namespace onggi::settings
