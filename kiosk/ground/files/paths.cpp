#include "kiosk/ground/files/paths.h"

#include <algorithm>

namespace fs = std::filesystem;

namespace onggi::files {

namespace {

fs::path root_at_or_above(fs::path folder) {
  std::error_code ignored;
  for (;; folder = folder.parent_path()) {
    if (fs::exists(folder / "config" / "exhibit.toml", ignored) &&
        fs::is_directory(folder / "content", ignored))
      return folder;
    if (folder == folder.parent_path()) return {};
  }
}

}  // namespace

Result<fs::path> program_root() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error)
    if (fs::path root = root_at_or_above(program.parent_path()); !root.empty()) return root;
  if (fs::path root = root_at_or_above(fs::current_path(error)); !root.empty()) return root;
  return problem(
      program.string(), "No folder at or above the program holds config/exhibit.toml and content/.",
      "Start onggi from its project folder, or name the exhibit: onggi run --config FILE.");
}

Result<fs::path> exhibit_file(const std::string& given) {
  if (!given.empty()) {
    std::error_code error;
    if (fs::is_directory(given, error)) return fs::path(given) / "exhibit.toml";
    return fs::path(given);
  }
  std::error_code ignored;
  if (const fs::path site = root_at_or_above(fs::current_path(ignored)); !site.empty())
    return site / "config" / "exhibit.toml";
  auto root = program_root();
  if (!root) return tl::unexpected(root.error());
  return *root / "config" / "exhibit.toml";
}

fs::path site_exhibit(const fs::path& path) {
  std::error_code ignored;
  const fs::path site = root_at_or_above(fs::absolute(path, ignored).lexically_normal());
  return site.empty() ? site : site / "config" / "exhibit.toml";
}

fs::path language_folder(const fs::path& file) {
  std::error_code ignored;
  if (const fs::path own = site_exhibit(file).parent_path().parent_path() / "content" / "languages";
      own.is_absolute() && fs::is_directory(own, ignored))
    return own;
  const auto root = program_root();
  return root ? *root / "content" / "languages" : fs::path();
}

fs::path real_path(const fs::path& path) {
  std::error_code error;
  fs::path found = fs::weakly_canonical(fs::absolute(path, error), error);
  if (error) found = path.lexically_normal();
  return found.has_filename() ? found : found.parent_path();
}

bool is_within(const fs::path& inner, const fs::path& outer) {
  const fs::path lower = real_path(inner), upper = real_path(outer);
  return std::mismatch(upper.begin(), upper.end(), lower.begin(), lower.end()).first == upper.end();
}

fs::path store_file(const fs::path& folder) { return folder / "onggi.sqlite"; }

}  // namespace onggi::files
