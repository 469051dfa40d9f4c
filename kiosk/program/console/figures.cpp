#include "kiosk/program/console/figures.h"

#include <utility>

#include "kiosk/ground/files/paths.h"
#include "kiosk/program/desk/published.h"

namespace onggi::console {

Result<const store::AnonymisedStatistics*> Figures::of(const std::filesystem::path& keepsakes,
                                                       const std::string& from,
                                                       const std::string& to, std::int64_t now) {
  if (!desk::is_day(from) || !desk::is_day(to))
    return problem("from=" + from + " to=" + to, "This is not a day.", "Write it as 2026-05-31.");
  const std::string key = keepsakes.string() + '\n' + from + '\n' + to;
  if (key != key_ || now - read_at_ >= kEvery || now < read_at_) {
    const auto counted = store::read_statistics(files::store_file(keepsakes).string(), from, to);
    if (!counted) return tl::unexpected(counted.error());
    told_ = store::publish(*counted);
    key_ = key;
    read_at_ = now;
  }
  return &told_;
}

}  // namespace onggi::console
