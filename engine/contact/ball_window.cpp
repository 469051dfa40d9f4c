#include "engine/contact/ball_window.h"

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

int wrapped_blocks(const Clay& clay, int low, int high, BlockRun* ranges) noexcept {
  const int sectors = clay.sectors();
  const int all = clay.stride() / 8;
  ranges[0] = {0, all};
  if (high - low + 1 >= sectors) return 1;
  const int shift = low < 0 ? sectors : low >= sectors ? -sectors : 0;
  low += shift;
  high += shift;
  if (high < sectors) {
    ranges[0] = {low / 8, high / 8 + 1};
    return 1;
  }
  const BlockRun wrapped{0, (high - sectors) / 8 + 1};
  if (wrapped.end > low / 8) return 1;  // the two ends meet in one block: the full circle
  ranges[0] = {low / 8, all};
  ranges[1] = wrapped;
  return 2;
}

void plan_rows(const Clay& clay, const BallWindow& window, WallSide side, int first, int count,
               RowReach* rows) noexcept {
  BallWindows found;
  const double* heights = clay.row_heights().data() + first;
  const float* extents =
      (side == WallSide::outside ? clay.outer_most() : clay.inner_least()).data() + first;
  for (int k = 0; k < count; ++k) {
    found.above[k] = static_cast<float>(window.height - heights[k]);
    found.extent[k] = extents[k];
  }
  for (int k = count; k % 8 != 0; ++k) found.above[k] = found.extent[k] = 0.0f;

  const double per_radian = clay.sectors() / (2.0 * portable::kPi);
  // Two whole turns added keep the figures positive, where casting is flooring.
  const int turns = 2 * clay.sectors();
  const WindowFigures figures{static_cast<float>(window.radius),
                              static_cast<float>(window.distance), static_cast<float>(per_radian),
                              static_cast<float>(1.0 / per_radian),
                              static_cast<float>(window.middle + turns)};
  kernels(clay.vectors()).windows(side, figures, count, found);
  for (int k = 0; k < count; ++k) {
    RowReach& row = rows[k];
    row.above = found.above[k];
    row.section = found.section[k];
    row.width = found.width[k];
    row.per_width = found.per_width[k];
    row.edged = 2.0f * found.section[k] < found.width[k] ||
                (side == WallSide::outside ? found.extent[k] + 1e-6f > found.end[k]
                                           : found.extent[k] - 1e-6f < found.end[k]);
    row.used = 0;
    // The element beyond the upper end covers the rounding.
    if (found.half[k] >= 0.0f)
      row.used = wrapped_blocks(clay, found.low[k] - turns, found.high[k] + 1 - turns, row.ranges);
  }
}

}  // namespace onggi::contact
