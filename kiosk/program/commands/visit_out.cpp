#include "kiosk/program/commands/visit_out.h"

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/plain_text.h"
#include "kiosk/collection/settings/exhibit.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/keepsake/souvenir/visit_folder.h"

namespace fs = std::filesystem;

namespace onggi::commands {
namespace {

/// True for "07_result.png".
bool is_a_screen(const std::string& name) {
  return name.ends_with(".png") && name.find('_') != std::string::npos &&
         name.find_first_not_of("0123456789") == name.find('_');
}

bool is_ours(const fs::path& entry) {
  const std::string name = entry.filename().string();
  return name == "visit.json" || name == "said.txt" || name == "screens" || name == "phone" ||
         name.starts_with("onggi.sqlite") || souvenir::is_visit_name(name);
}

/// The first name in `folder` for which `ours` is false; "" if there is none.
template <class Ours>
std::string another_thing(const fs::path& folder, Ours ours) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  std::string first;
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    if (!ours(entry->path()) && (first.empty() || entry->path().filename().string() < first))
      first = entry->path().filename().string();
  return first;
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

}  // namespace

Result<void> make_visit_out(const fs::path& out, const fs::path& config) {
  const std::string where = "--out " + out.string();
  const std::string remedy = "Name a new folder, or that of an earlier onggi visit.";
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::absolute(out, error), error);
  std::vector<fs::path> museums_own{settings::read_exhibit(config).exhibit.shelf,
                                    files::language_folder(config)};
  if (const fs::path own = files::site_exhibit(config); fs::equivalent(own, config, error))
    for (const char* part : {"config", "content"})
      museums_own.push_back(own.parent_path().parent_path() / part);
  for (const fs::path& folder : museums_own)
    if (const fs::path museums = fs::canonical(folder, error); !error && is_within(real, museums))
      return problem(
          where, "This folder belongs to the exhibit: it lies in " + folder.string() + ".", remedy);
  if (fs::create_directories(out, error); error || !fs::is_directory(out, error))
    return problem(where, "This folder does not exist and cannot be created.",
                   "Name a writable folder.");
  std::string other = another_thing(real, is_ours);
  if (other.empty())
    other = another_thing(real / "screens", [](const fs::path& entry) {
      return is_a_screen(entry.filename().string());
    });
  if (!other.empty())
    return problem(where, "Something else lies in this folder: " + terminal::plain(other) + ".",
                   remedy);
  return {};
}

}  // namespace onggi::commands
