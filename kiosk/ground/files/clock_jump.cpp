#include "kiosk/ground/files/clock_jump.h"

#include <algorithm>
#include <string>

namespace onggi::files {

bool clock_jumped(std::span<const std::time_t> times, std::time_t now) {
  std::optional<std::time_t> before;
  std::time_t after = now;
  for (const std::time_t at : times) {
    if (at > now) continue;
    if (at > now - kDistrust)
      after = std::min(after, at);
    else
      before = std::max(before.value_or(at), at);
  }
  return before && after - *before > kJump;
}

std::optional<std::time_t> time_of_stamp(std::string_view stamp) {
  std::tm local{};
  if (::strptime(std::string(stamp).c_str(), "%Y-%m-%d_%H%M%S", &local) == nullptr)
    return std::nullopt;
  local.tm_isdst = -1;  // let mktime decide
  return std::mktime(&local);
}

}  // namespace onggi::files
