#include "engine/contact/window.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/window.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/plan_rows.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

void plan_here(const Clay& clay, const Window& window, WallSide side, int first, int count,
               RowReach* rows) {
  if (side == WallSide::outside)
    plan<WallSide::outside>(clay, window, first, count, rows);
  else
    plan<WallSide::inside>(clay, window, first, count, rows);
}

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi {

HWY_EXPORT(plan_here);

double cross_section(double radius, double dy) noexcept {
  const double off = std::fabs(dy);
  return off < radius ? std::sqrt((radius - off) * (radius + off)) : -1.0;
}

Window::Window(const Clay& clay, Vec3 at, double reach) noexcept
    : height(at.y),
      radius(reach),
      distance(axis_distance(at)),
      middle(portable::atan2(at.z, at.x) * (clay.sectors() / (2.0 * portable::kPi)) - 0.5),
      first_row(clay.first_row_above(at.y - reach)),
      end_row(clay.first_row_above(at.y + reach)) {}

void plan_rows(const Clay& clay, const Window& window, WallSide side, int first, int count,
               RowReach* rows) noexcept {
  HWY_DYNAMIC_DISPATCH(plan_here)(clay, window, side, first, count, rows);
}

}  // namespace onggi
#endif
