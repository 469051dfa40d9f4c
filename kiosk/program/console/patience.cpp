#include "kiosk/program/console/patience.h"

#include <algorithm>

namespace onggi::console {

std::int64_t Patience::wait(const std::string& name, const std::string& address,
                            std::int64_t now) const {
  const auto found = tries_.find({name, address});
  if (found == tries_.end()) return 0;
  // A clock that was set back makes nobody wait longer.
  return std::clamp<std::int64_t>(found->second.next - now, 0, found->second.pause);
}

void Patience::wrong(const std::string& name, const std::string& address, std::int64_t now) {
  const std::pair key(name, address);
  if (tries_.size() >= kMost && !tries_.contains(key))
    tries_.erase(std::min_element(tries_.begin(), tries_.end(),
                                  [](auto& a, auto& b) { return a.second.next < b.second.next; }));
  Tries& tries = tries_[key];
  tries.pause = std::clamp<std::int64_t>(2 * tries.pause, 1, kLongest);
  tries.next = now + tries.pause;
}

void Patience::right(const std::string& name, const std::string& address) {
  tries_.erase({name, address});
}

}  // namespace onggi::console
