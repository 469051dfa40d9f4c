// Window planning for eight rows at once (window.h). Compiled once for each kind of vector: include
// it only from files that hwy/foreach_target.h compiles again.
#if defined(ONGGI_CONTACT_PLAN_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_PLAN_ROWS_H
#undef ONGGI_CONTACT_PLAN_ROWS_H
#else
#define ONGGI_CONTACT_PLAN_ROWS_H
#endif

#include "engine/contact/window.h"
#include "engine/math/lanes.h"
#include "engine/math/portable.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {

static_assert(kPlannedRows % kLanes == 0);

inline constexpr float kQuarterTurn = static_cast<float>(0.5 * portable::kPi);

// Never less than the arc cosine of c (-1..1), and at most 4 % or 0.05 rad more. From
// asin(s) <= s (1 + (pi/2 - 1) s^2) for 0 <= s <= 1, since (asin(s)/s - 1)/s^2 grows, and from
// asin(c) >= c + c^3/6.
HWY_INLINE Float8 widest_acos(Float8 c) {
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

// Where the tool's ball, of radius r in the row, passes the row's extent s: its end lies at d -+ r
// before the tool and at t at the tangents, and passes s in between, where the circle round the
// axis and the circle round the tool cross. Gives half the window's angle, negative where nothing
// is reached.
template <WallSide side>
HWY_INLINE Float8 half_window(Float8 d, Float8 r, Float8 t, Float8 s) {
  const Float8 between = (d - r) * (d + r);
  const Float8 tiny = all(1e-9f);
  // Rounding may take a ray's end for a little nearer than it is.
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
  // Near 1 a rounding of the cosine is the square of the angle's.
  const Float8 cosine = (between + s * s) / larger(twice, all(1e-18f)) - all(1e-6f);
  const Float8 bounded = larger(smaller(cosine, all(1.0f)), all(-1.0f));
  const Float8 half = select(full, all(2.0f * kQuarterTurn), widest_acos(bounded));
  return select(reached, half, all(-1.0f));
}

// The ranges of blocks from element `low` to element `high`, wrapped.
inline void set_ranges(RowReach& row, int low, int high, int sectors, int all_blocks) {
  row.used = 1;
  row.ranges[0] = {0, all_blocks};
  if (high - low + 1 >= sectors) return;
  const int shift = low < 0 ? sectors : low >= sectors ? -sectors : 0;
  low += shift;
  high += shift;
  if (high < sectors) {
    row.ranges[0] = {low / kLanes, high / kLanes + 1};
    return;
  }
  const BlockRange wrapped{0, (high - sectors) / kLanes + 1};
  if (wrapped.end > low / kLanes) return;  // the two ends meet in one block: the full circle
  row.ranges[0] = {low / kLanes, all_blocks};
  row.ranges[1] = wrapped;
  row.used = 2;
}

struct PlannedFigures {
  float above[kPlannedRows], extent[kPlannedRows];
  float section[kPlannedRows], width[kPlannedRows], per_width[kPlannedRows];
  float end[kPlannedRows], half[kPlannedRows];
  int low[kPlannedRows], high[kPlannedRows];
};

/// See window.h.
template <WallSide side>
HWY_INLINE void plan(const Clay& clay, const Window& window, int first, int count, RowReach* rows) {
  PlannedFigures rest;
  const double* heights = clay.row_heights().data() + first;
  const float* extents =
      (side == WallSide::outside ? clay.outer_most() : clay.inner_least()).data() + first;
  for (int k = 0; k < count; ++k) {
    rest.above[k] = static_cast<float>(window.height - heights[k]);
    rest.extent[k] = extents[k];
  }
  for (int k = count; k % kLanes != 0; ++k) rest.above[k] = rest.extent[k] = 0.0f;

  const Float8 zero = all(0.0f);
  const Float8 radius = all(static_cast<float>(window.radius));
  const Float8 distance = all(static_cast<float>(window.distance));
  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  // Two whole turns added keep the figures positive, where casting is flooring.
  const int turns = 2 * clay.sectors();
  const Float8 middle = all(static_cast<float>(window.middle + turns));
  for (int k = 0; k < count; k += kLanes) {
    const Float8 off = abs(load(rest.above + k));
    const Float8 section = sqrt(larger((radius - off) * (radius + off), zero));
    const Float8 tangent = sqrt(larger((distance - section) * (distance + section), zero));
    // Elements of which only a part is covered lie up to half a width beyond.
    const Float8 angle = half_window<side>(distance, section, tangent, load(rest.extent + k));
    const Float8 half = all(0.5f) + angle * all(static_cast<float>(per_radian));
    // Where the section ends on the ray that passes half an element within its edge.
    const Float8 width = larger(tangent * all(static_cast<float>(1.0 / per_radian)), all(1e-9f));
    const Float8 within = section - all(0.5f) * width;
    const Float8 along = sqrt(larger((distance - within) * (distance + within), zero));
    const Float8 chord = sqrt(larger((section - within) * (section + within), zero));
    store(section, rest.section + k);
    store(width, rest.width + k);
    store(all(1.0f) / width, rest.per_width + k);
    store(side == WallSide::outside ? along - chord : along + chord, rest.end + k);
    store(half, rest.half + k);
    store_whole(middle - half, rest.low + k);
    store_whole(middle + half, rest.high + k);
  }
  for (int k = 0; k < count; ++k) {
    RowReach& row = rows[k];
    row.above = rest.above[k];
    row.section = rest.section[k];
    row.width = rest.width[k];
    row.per_width = rest.per_width[k];
    row.edged = 2.0f * rest.section[k] < rest.width[k] ||
                (side == WallSide::outside ? rest.extent[k] + 1e-6f > rest.end[k]
                                           : rest.extent[k] - 1e-6f < rest.end[k]);
    row.used = 0;
    // The element beyond the upper end covers the rounding.
    if (rest.half[k] >= 0.0f)
      set_ranges(row, rest.low[k] - turns, rest.high[k] + 1 - turns, clay.sectors(),
                 clay.stride() / kLanes);
  }
}

}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
