#include "tests/bench/floor_loop.h"

#include <algorithm>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tests/bench/floor_loop.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/plan_rows.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

template <WallSide side>
std::int64_t floor_side(Clay& clay, Vec3 at, double radius, double decay) {
  constexpr bool outside = side == WallSide::outside;
  const Window window(clay, at, radius);
  const float* ray_cos = clay.ray_cos().data();
  const float* ray_sin = clay.ray_sin().data();
  const Float8 x = all(static_cast<float>(at.x));
  const Float8 z = all(static_cast<float>(at.z));
  const Float8 gone = all(static_cast<float>(1.0 - decay));
  const Float8 wall_min = all(static_cast<float>(clay.def().wall_min));
  const Float8 zero = all(0.0f);
  std::int64_t visited = 0;
  const int first = outside ? window.first_row : std::max(window.first_row, clay.floor_rows());
  RowReach planned[kPlannedRows];
  for (int j = first, k = kPlannedRows; j < window.end_row; ++j, ++k) {
    if (k == kPlannedRows) {
      k = 0;
      plan<side>(clay, window, j, std::min(kPlannedRows, window.end_row - j), planned);
    }
    const RowReach& reach = planned[k];
    const Float8 r = all(reach.section);
    float* outer = clay.pressable_outer(j).data();
    float* inner = clay.pressable_inner(j).data();
    float* face = outside ? outer : inner;
    float* behind = outside ? inner : outer;
    for (int n = 0; n < reach.used; ++n) {
      for (int i = reach.ranges[n].begin * kLanes; i < reach.ranges[n].end * kLanes; i += kLanes) {
        const Float8 c = load(ray_cos + i);
        const Float8 s = load(ray_sin + i);
        const Float8 surface = load(face + i);
        const Float8 along = x * c + z * s;
        const Float8 off = z * c - x * s;
        const Float8 square = (r - off) * (r + off);
        const Float8 half_chord = sqrt(larger(square, zero));
        const Float8 end = outside ? along - half_chord : along + half_chord;
        const Float8 press = outside ? surface - end : end - surface;
        const Mask8 touch = (square > zero) & (press > zero);
        if (none(touch)) continue;
        const Float8 given = only(touch, press) * gone;
        const Float8 now = outside ? surface - given : surface + given;
        store(now, face + i);
        const Float8 back = load(behind + i);
        const Float8 least = outside ? now - wall_min : now + wall_min;
        const Mask8 pushed = touch & (outside ? least < back : least > back);
        if (!none(pushed)) store(select(pushed, least, back), behind + i);
      }
    }
    visited += reach.elements();
  }
  return visited;
}

std::int64_t floor_here(Clay& clay, WallSide side, Vec3 at, double radius, double decay) {
  return side == WallSide::outside ? floor_side<WallSide::outside>(clay, at, radius, decay)
                                   : floor_side<WallSide::inside>(clay, at, radius, decay);
}

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi::bench {
namespace {
using namespace onggi;
HWY_EXPORT(floor_here);
}  // namespace

std::int64_t floor_loop(Clay& clay, WallSide side, Vec3 at, double radius, double decay) noexcept {
  return HWY_DYNAMIC_DISPATCH(floor_here)(clay, side, at, radius, decay);
}

}  // namespace onggi::bench
#endif
