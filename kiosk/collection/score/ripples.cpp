#include "kiosk/collection/score/ripples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "kiosk/collection/score/remarks.h"

namespace onggi::score {

namespace {

constexpr int kRows = 256;
/// Half the height over which the wall's own curve is smoothed away: wider than a fingertip's ring,
/// narrower than a belly. Share of the height.
constexpr double kCurve = 0.06;
/// Nobody sees a shallower ripple. Share of the vessel's size, as a radius.
constexpr double kShallow = 0.003;
/// So many swings more than the vessel's own are ripples. A corner of a wrong shape makes three.
constexpr int kMany = 5;

struct Swings {
  int count = 0;  ///< Changes from a ring that stands out to one that lies back, or the other way.
  double depth = 0.0;  ///< Their mean depth from ring to groove, metres of radius.
};

/// The outline's swings about its own smooth curve, at `factor` times its size.
Swings swings_of(const Profile& p, double factor, double shallow) {
  std::array<double, kRows + 1> radius;
  for (std::size_t i = 0; i <= kRows; ++i)
    radius[i] = factor * p.outer_at(p.height() * static_cast<double>(i) / kRows);
  const auto reach = static_cast<std::size_t>(kCurve * kRows);
  Swings out;
  double furthest = 0.0, depths = 0.0;
  for (std::size_t i = reach; i + reach <= kRows; ++i) {
    double mean = 0.0;
    for (std::size_t k = i - reach; k <= i + reach; ++k)
      mean += radius[k] / (2.0 * static_cast<double>(reach) + 1.0);
    const double off = radius[i] - mean;
    if (std::abs(off) < shallow) continue;
    if (off * furthest < 0.0) {
      ++out.count;
      depths += std::abs(furthest);
      furthest = 0.0;
    }
    if (std::abs(off) > std::abs(furthest)) furthest = off;
  }
  if (out.count > 0) out.depth = 2.0 * depths / out.count;
  return out;
}

}  // namespace

double ripples(const Profile& vessel, const Profile& made) {
  const double shallow = kShallow * size_of(dimensions(vessel));
  const Swings own = swings_of(vessel, 1.0, shallow);
  const Swings got = swings_of(made, vessel.height() / made.height(), shallow);
  return got.count - own.count < kMany ? 0.0 : 2.0 * got.depth;
}

}  // namespace onggi::score
