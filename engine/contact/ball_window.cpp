#include "engine/contact/ball_window.h"

#include <algorithm>
#include "engine/contact/kernels.h"
#include "engine/math/portable.h"

namespace onggi::contact {

BallWindow::BallWindow(const Clay& clay, Vec3 at, double reach) noexcept
    : height(at.y),
      radius(reach),
      distance(axis_distance(at)),
      middle(portable::atan2(at.z, at.x) * (clay.sectors() / (2.0 * portable::kPi)) - 0.5),
      first_row(clay.first_row_above(at.y - reach)),
      end_row(clay.first_row_above(at.y + reach)) {}

void plan_rows(const Clay& clay, const BallWindow& window, WallSide side, int first, int count,
               BallWindows& rows) noexcept {
  const double* heights = clay.row_heights().data() + first;
  const float* extents =
      (side == WallSide::outside ? clay.outer_most() : clay.inner_least()).data() + first;
  for (int k = 0; k < count; ++k) {
    rows.above[k] = static_cast<float>(window.height - heights[k]);
    rows.extent[k] = extents[k];
  }
  for (int k = count; k % 8 != 0; ++k) rows.above[k] = rows.extent[k] = 0.0f;

  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  // Add two whole turns: for positive figures a cast is a floor.
  const int turns = 2 * clay.sectors();
  const ClayDef& def = clay.def();
  const WindowFigures figures{
      static_cast<float>(window.radius),
      static_cast<float>(window.distance),
      static_cast<float>(1.0 / window.radius),
      static_cast<float>(per_radian),
      static_cast<float>(1.0 / per_radian),
      static_cast<float>(window.middle + turns),
      static_cast<float>(side == WallSide::outside ? def.radius_min + def.wall_min
                                                   : def.radius_max - def.wall_min)};
  kernels(clay.vectors()).windows(side, figures, count, rows);
  if (count < kPlannedRows) rows.reached &= (1u << count) - 1;
}

double slope_beside(const Clay& clay, const BallWindow& window, WallSide side) noexcept {
  const bool outside = side == WallSide::outside;
  const int lowest = outside ? 0 : clay.floor_rows(), highest = clay.rows() - 1;
  if (lowest >= highest) return 0.0;
  const double* const heights = clay.row_heights().data();
  const int* const stored = clay.stored().data();
  const float* const face = outside ? clay.stored_outer(0) : clay.stored_inner(0);
  const long stride = clay.stride();
  const double place = window.middle + clay.sectors();  // positive: a cast is a floor
  const int whole = static_cast<int>(place);
  const int ray = whole < clay.sectors() ? whole : whole - clay.sectors();
  const int next = ray + 1 < clay.sectors() ? ray + 1 : 0;
  const double on = place - whole;
  struct Point {
    double radius, height;
  };
  // Between the rows next to height y; `above` is where to look first.
  const auto point_at = [&](double y, int above) -> Point {
    above = std::clamp(above, lowest + 1, highest);
    while (above < highest && heights[above] < y) ++above;
    while (above > lowest + 1 && heights[above - 1] > y) --above;
    const double under = heights[above - 1], rise = heights[above] - under;
    const double up = std::clamp((y - under) / rise, 0.0, 1.0);
    const float* const low = face + stride * stored[above - 1];
    const float* const high = face + stride * stored[above];
    const double here = low[ray] + up * (double{high[ray]} - double{low[ray]});
    const double there = low[next] + up * (double{high[next]} - double{low[next]});
    return {here + on * (there - here), under + up * rise};
  };
  const int quarter = (window.end_row - window.first_row) / 4;
  const Point low = point_at(window.height - 0.5 * window.radius, window.first_row + quarter);
  const Point high = point_at(window.height + 0.5 * window.radius, window.end_row - quarter);
  return high.height > low.height ? (high.radius - low.radius) / (high.height - low.height) : 0.0;
}

}  // namespace onggi::contact
