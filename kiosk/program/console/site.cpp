#include "kiosk/program/console/site.h"

#include <utility>

#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/paths.h"

namespace onggi::console {

namespace fs = std::filesystem;

Result<Site> Site::open(const fs::path& folder) {
  std::error_code error;
  fs::path file = fs::absolute(folder, error).lexically_normal();
  if (fs::is_directory(file, error))
    file /=
        fs::is_regular_file(file / "exhibit.toml", error) ? "exhibit.toml" : "config/exhibit.toml";
  if (!fs::is_regular_file(file, error))
    return problem("--site " + folder.string(),
                   error && error != std::errc::no_such_file_or_directory
                       ? "This exhibit cannot be read: " + error.message() + "."
                       : "There is no exhibit here: no " + file.string() + ".",
                   "Name the folder above config/exhibit.toml; this program's user must be able to "
                   "read it.");
  return Site(file);
}

const settings::Exhibit& Site::exhibit() {
  const std::string stamp = files::stamp_of(file_).value_or("gone");
  // A file that is being written may be gone for a moment: what it said still holds.
  if (stamp != stamp_ && stamp != "gone") {
    exhibit_ = settings::read_exhibit(file_).exhibit;
    stamp_ = stamp;
  }
  return exhibit_;
}

std::string Site::title() {
  const settings::Exhibit& e = exhibit();
  for (const std::string& language :
       {e.languages.empty() ? "en" : e.languages.front(), std::string("en")})
    if (const auto found = e.title.find(language); found != e.title.end()) return found->second;
  return e.title.empty() ? "" : e.title.begin()->second;
}

}  // namespace onggi::console
