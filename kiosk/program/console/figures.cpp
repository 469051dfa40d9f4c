#include "kiosk/program/console/figures.h"

#include <utility>

#include "kiosk/ground/files/file_stamps.h"
#include "kiosk/ground/files/paths.h"
#include "kiosk/program/desk/published.h"

namespace onggi::console {

Result<const store::AnonymisedStatistics*> Figures::of(const std::filesystem::path& keepsakes,
                                                       const std::string& from,
                                                       const std::string& to, std::int64_t now) {
  if (!desk::is_day(from) || !desk::is_day(to))
    return problem("from=" + from + " to=" + to, "This is not a day.", "Write it as 2026-05-31.");
  const std::filesystem::path store = files::store_file(keepsakes);
  const std::string key = store.string() + '\n' + from + '\n' + to + '\n' +
                          files::stamp_of(store).value_or("") + '\n' +
                          files::stamp_of(store.string() + "-wal").value_or("");
  // Another span is asked for by somebody who waits for it.
  const bool same_days = key_.starts_with(store.string() + '\n' + from + '\n' + to + '\n');
  if (key != key_ && !(same_days && now >= read_at_ && now - read_at_ < kEvery)) {
    const auto counted = store::read_statistics(store.string(), from, to);
    if (counted)
      told_ = store::publish(*counted);
    else
      told_ = tl::unexpected(counted.error());
    key_ = key;
    read_at_ = now;
  }
  if (!told_) return tl::unexpected(told_.error());
  return &*told_;
}

}  // namespace onggi::console
