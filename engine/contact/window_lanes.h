#pragma once

// Plans windows for eight rows at once (ball_window.h). For *_lanes.cpp only.

#include "engine/clay/wall_side.h"
#include "engine/contact/kernels.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {

static_assert(contact::kPlannedRows % kLanes == 0);

inline constexpr float kQuarterTurn = 1.57079632679489662f;

// At least the arc cosine of c (-1..1), and at most 4 % or 0.05 rad more. From asin(s) <= s (1 +
// (pi/2 - 1) s^2) for 0 <= s <= 1, since (asin(s)/s - 1)/s^2 grows, and from asin(c) >= c + c^3/6.
ONGGI_INLINE Float8 widest_acos(Float8 c) {
  const Float8 one = all(1.0f);
  const Float8 quarter = all(kQuarterTurn);
  const Float8 bend = all(kQuarterTurn - 1.0f);
  const Float8 square = larger((one - c) * (one + c), all(0.0f));
  const Float8 by_sine = sqrt(square) * (one + bend * square);
  const Float8 size = abs(c);
  const Float8 cube = size * size * size;
  const Float8 acute = smaller(by_sine, quarter - (size + cube * all(1.0f / 6.0f)));
  return select(c < all(0.0f), quarter + size + bend * cube, acute);
}

// Where the tool's ball, of radius r in the row, passes the row's extent s. The ball's end lies at
// d -+ r in front of the tool and at t at the tangents. It passes s in between, where the circle
// round the axis crosses the circle round the tool. Returns half the window's angle, negative if
// nothing is reached.
template <WallSide side>
ONGGI_INLINE Float8 half_window(Float8 d, Float8 r, Float8 t, Float8 s) {
  const Float8 between = (d - r) * (d + r);
  const Float8 tiny = all(1e-9f);
  // Rounding may place a ray's end a little too near.
  const Float8 slack = all(4e-8f);
  Mask8 reached, full;
  if constexpr (side == WallSide::outside) {
    s = s + slack;
    reached = s > d - r;
    full = d < r + tiny;  // the axis is inside
    s = smaller(s, t);
  } else {
    s = s - slack;
    reached = s < d + r;
    full = (s < r - d) | (d < tiny);  // all round, the far side too
    s = larger(s, select(d < r, r - d, t));
  }
  const Float8 twice = all(2.0f) * d * larger(s, tiny);
  // Near 1, a rounding error in the cosine is the square of the angle's.
  const Float8 cosine = (between + s * s) / larger(twice, all(1e-18f)) - all(1e-6f);
  const Float8 bounded = larger(smaller(cosine, all(1.0f)), all(-1.0f));
  const Float8 half = select(full, all(2.0f * kQuarterTurn), widest_acos(bounded));
  return select(reached, half, all(-1.0f));
}

/// See kernels.h.
template <WallSide side>
ONGGI_INLINE void ball_windows_of(const contact::WindowFigures& figures, int count,
                                  contact::BallWindows& rows) {
  const Float8 zero = all(0.0f);
  const Float8 radius = all(figures.radius);
  const Float8 distance = all(figures.distance);
  const Float8 middle = all(figures.middle);
  rows.reached = rows.careful = 0;
  for (int k = 0; k < count; k += kLanes) {
    const Float8 above = load(rows.above + k);
    const Float8 extent = load(rows.extent + k);
    const Float8 off = abs(above);
    const Float8 section = sqrt(larger((radius - off) * (radius + off), zero));
    const Float8 tangent = sqrt(larger((distance - section) * (distance + section), zero));
    // Partly covered elements lie up to half a width beyond.
    const Float8 angle = half_window<side>(distance, section, tangent, extent);
    const Float8 half = all(0.5f) + angle * all(figures.per_radian);
    // Where the section ends on the ray that passes half an element inside its edge.
    const Float8 width = larger(tangent * all(figures.radians), all(1e-9f));
    const Float8 within = section - all(0.5f) * width;
    const Float8 along = sqrt(larger((distance - within) * (distance + within), zero));
    const Float8 chord = sqrt(larger((section - within) * (section + within), zero));
    const Float8 per_width = all(1.0f) / width;
    store(section, rows.section + k);
    store(section + all(0.5f) * width, rows.edge + k);
    store(per_width, rows.per_width + k);
    store(smaller(all(2.0f) * section * per_width, all(1.0f)), rows.most_covered + k);
    store(above * all(figures.per_radius), rows.above_radii + k);
    store_whole(middle - half, rows.low + k);
    store_whole(middle + half, rows.high + k);
    const Float8 end = side == WallSide::outside ? along - chord : along + chord;
    const Float8 slack = all(1e-6f);
    const Mask8 deep = side == WallSide::outside ? extent + slack > end : extent - slack < end;
    // Near the axis and near the clay's limits, the ball may ask for more than there is.
    const Mask8 beyond = side == WallSide::outside
                             ? distance - section < all(figures.limit) + slack
                             : distance + section > all(figures.limit) - slack;
    rows.careful |= bits(deep | (all(2.0f) * section < width) | beyond) << k;
    rows.reached |= bits(angle > all(-1.0f)) << k;
  }
}

}  // namespace onggi::ONGGI_LANES
