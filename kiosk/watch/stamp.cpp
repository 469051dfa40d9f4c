#include "kiosk/watch/stamp.h"

#include <set>

namespace fs = std::filesystem;

namespace onggi::watch {

std::optional<std::string> stamp_of(const fs::path& file) {
  std::error_code gone;  // an editor's own files come and go
  if (!fs::is_regular_file(file, gone)) return {};
  const auto size = fs::file_size(file, gone);
  if (gone) return {};
  const auto time = fs::last_write_time(file, gone).time_since_epoch().count();
  if (gone) return {};
  return std::to_string(size) + ' ' + std::to_string(time);
}

std::string stamps_in(const std::vector<fs::path>& folders) {
  std::set<std::string> lines;
  for (const fs::path& folder : folders) {
    std::error_code gone;
    for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
      if (const auto stamp = stamp_of(it->path()))
        lines.insert(it->path().string() + ' ' + *stamp + '\n');
  }
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

}  // namespace onggi::watch
