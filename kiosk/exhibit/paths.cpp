#include "kiosk/exhibit/paths.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {

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
  auto root = program_root();
  if (!root) return tl::unexpected(root.error());
  return *root / "config" / "exhibit.toml";
}

}  // namespace onggi::exhibit
