#include "kiosk/collection/content/scan_folder.h"

#include <algorithm>
#include <string>
#include <system_error>

#include "kiosk/collection/content/json_words.h"
#include "kiosk/collection/content/mesh_file.h"
#include "kiosk/collection/content/scan_document.h"

namespace onggi::content {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (at.depth() >= kDeepest) at.disable_recursion_pending();
    std::error_code ignored;
    if (at->symlink_status(ignored).type() == fs::file_type::regular) files.push_back(at->path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

FolderScans scans_in(const fs::path& folder, const settings::ReaderLimits& limits) {
  FolderScans found;
  for (const fs::path& file : files_in(folder)) {
    if (is_mesh_ending(json_words::lower(file.extension().string())))
      found.meshes.push_back(file.lexically_relative(folder));
    if (!is_scan_document(file)) continue;
    if (const auto document = read_scan_document(file, limits); document)
      found.documents.push_back(file.lexically_relative(folder));
    else
      found.unusable.push_back(document.error());
  }
  return found;
}

}  // namespace onggi::content
