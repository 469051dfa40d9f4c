#include "kiosk/program/console/kept_files.h"

#include <algorithm>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

namespace onggi::console {

namespace fs = std::filesystem;

void keep_newest(const fs::path& folder, std::size_t most) {
  std::vector<std::pair<fs::file_time_type, fs::path>> all;
  std::error_code gone;
  for (fs::directory_iterator it(folder, gone), end; !gone && it != end; it.increment(gone))
    all.emplace_back(it->last_write_time(gone), it->path());
  std::ranges::sort(all, std::ranges::greater{});
  for (std::size_t n = most; n < all.size(); ++n) fs::remove(all[n].second, gone);
}

}  // namespace onggi::console
