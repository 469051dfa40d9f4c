#include "kiosk/ground/files/file_stamps.h"

#include <utility>

namespace fs = std::filesystem;

namespace onggi::files {

namespace {
fs::path plain(const fs::path& file) {
  std::error_code none;
  return fs::absolute(file, none).lexically_normal();
}
}  // namespace

std::optional<std::string> stamp_of(const fs::path& file) {
  std::error_code gone;  // an editor's temporary files come and go
  if (!fs::is_regular_file(file, gone)) return {};
  const auto size = fs::file_size(file, gone);
  if (gone) return {};
  const auto time = fs::last_write_time(file, gone).time_since_epoch().count();
  if (gone) return {};
  return std::to_string(size) + ' ' + std::to_string(time);
}

Stamps stamps_in(const std::vector<fs::path>& folders) {
  Stamps stamps;
  for (const fs::path& folder : folders) {
    std::error_code gone;
    for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
      if (auto stamp = stamp_of(it->path())) stamps[plain(it->path())] = std::move(*stamp);
  }
  return stamps;
}

Stamps of_files(const Stamps& stamps, const std::vector<fs::path>& files) {
  Stamps found;
  for (const fs::path& file : files)
    if (const auto at = stamps.find(plain(file)); at != stamps.end()) found.insert(*at);
  return found;
}

}  // namespace onggi::files
