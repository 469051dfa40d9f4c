#pragma once

#include <cstdint>
#include <vector>

#include "kiosk/keepsake/souvenir/pass_file.h"

namespace onggi::souvenir {

/// Which passes are over for good, so that the keepsakes that they promised may go. A page closes
/// by the clock alone and opens again when the clock is right; what is removed does not come back,
/// and a clock may be wrong: a flat battery, no network. So here time counts only as the passes'
/// own dates vouch for it: between two of them, and from the last to now, no more than a night, and
/// no more than two thirds of a pass's hours. However far a clock leaps, it takes no more than that
/// from a promise.
class PassAges {
 public:
  /// s: the longest that a museum with a visit each day is closed.
  static constexpr std::int64_t kMostOfAGap = 16 * 3600;

  PassAges() = default;
  /// `given`: Pass::from of the passes there are, in any order.
  explicit PassAges(std::vector<std::int64_t> given);

  /// True if `pass` is over by the clock, which says `now`, and by the others' dates too.
  bool over(const Pass& pass, std::int64_t now) const;

 private:
  std::vector<std::int64_t> given_;  // sorted
};

}  // namespace onggi::souvenir
