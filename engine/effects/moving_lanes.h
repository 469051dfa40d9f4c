#pragma once

// Moves eight elements of a face, and the other face with them. For *_lanes.cpp only.

#include "engine/effects/row_kernels.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {

inline constexpr float kBeyondClay = 2.0f;  // m: padding, not a radius

ONGGI_INLINE Mask8 real(Float8 radius) { return abs(radius) < all(kBeyondClay); }
ONGGI_INLINE Float8 within(Float8 v, Float8 low, Float8 high) {
  return smaller(larger(v, low), high);
}

/// FaceMoved for each lane.
struct MovedLanes {
  Float8 lost = all(0.0f), outermost = all(0.0f), innermost = all(1e9f);

  ONGGI_INLINE row_kernels::FaceMoved all_of_them() const {
    return {sum(lost), largest(outermost), smallest(innermost)};
  }
};

/// Moves by `way` (m), as move_face() describes.
template <bool outside, bool hollow>
ONGGI_INLINE void move_lanes(const row_kernels::FaceMove& how, Float8 way, float* face,
                             float* behind, MovedLanes& sums) {
  const Float8 zero = all(0.0f);
  const Float8 radius = load(face);
  const Mask8 moves = (abs(way) > zero) & real(radius);
  if (none(moves)) return;
  // A face already beyond a limit goes no farther.
  const Float8 asked = outside ? radius - way : radius + way;
  const Float8 held = within(asked, smaller(all(how.near), radius), larger(all(how.far), radius));
  const Float8 now = select(moves, held, radius);
  const Float8 gone = (radius - now) * (radius + now);
  store(now, face);
  Float8 area = only(moves, outside ? gone : zero - gone);
  sums.outermost = larger(only(moves, now), sums.outermost);
  if constexpr (hollow) {
    const Float8 back = load(behind);
    const Float8 square = larger(back * back - all(how.along) * gone, zero);
    Float8 then =
        within(sqrt(square), smaller(all(how.back_near), back), larger(all(how.back_far), back));
    then = outside ? smaller(then, now - all(how.wall_min)) : larger(then, now + all(how.wall_min));
    then = select(moves, then, back);
    store(then, behind);
    const Float8 moved = only(moves, (back - then) * (back + then));
    area = outside ? area - moved : area + moved;
    sums.innermost = smaller(select(moves, outside ? then : now, all(1e9f)), sums.innermost);
    sums.outermost = larger(only(moves, outside ? now : then), sums.outermost);
  }
  sums.lost = sums.lost + area;
}

}  // namespace onggi::ONGGI_LANES
