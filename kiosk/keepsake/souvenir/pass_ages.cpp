#include "kiosk/keepsake/souvenir/pass_ages.h"

#include <algorithm>
#include <utility>

namespace onggi::souvenir {

PassAges::PassAges(std::vector<std::int64_t> given) : given_(std::move(given)) {
  std::ranges::sort(given_);
}

bool PassAges::over(const Pass& pass, std::int64_t now) const {
  if (now < pass.until) return false;
  const std::int64_t hours = pass.until - pass.from;
  const std::int64_t most = std::min(kMostOfAGap, hours / 3 * 2);
  std::int64_t passed = 0, last = pass.from;
  for (auto at = std::ranges::upper_bound(given_, pass.from);
       at != given_.end() && *at < now && passed < hours; ++at) {
    passed += std::min(*at - last, most);
    last = *at;
  }
  return passed + std::min(now - last, most) >= hours;
}

}  // namespace onggi::souvenir
