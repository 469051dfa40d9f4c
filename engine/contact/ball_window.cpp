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

}  // namespace onggi::contact
