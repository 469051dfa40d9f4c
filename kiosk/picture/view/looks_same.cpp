#include "kiosk/picture/view/looks_same.h"

#include <cmath>

namespace onggi::view {
namespace {

constexpr double kAngle = 2e-4, kPlace = 2e-5, kWet = 2.0 / 255.0;

/// Takes `drawn`'s value if the eye cannot tell the difference.
template <typename Number>
void forgive(Number& now, Number drawn, double by) {
  if (std::abs(static_cast<double>(now) - static_cast<double>(drawn)) < by) now = drawn;
}

void forgive(Vec3& now, const Vec3& drawn) {
  forgive(now.x, drawn.x, kPlace);
  forgive(now.y, drawn.y, kPlace);
  forgive(now.z, drawn.z, kPlace);
}

}  // namespace

bool looks_same(const PotView& drawn, const PotView& now) {
  if (drawn.wetness_by_row.size() != now.wetness_by_row.size()) return false;
  PotView seen = now;
  forgive(seen.wheel_angle, drawn.wheel_angle, kAngle);
  forgive(seen.clay_angle, drawn.clay_angle, kAngle);
  forgive(seen.wetness, drawn.wetness, kWet);
  for (std::size_t i = 0; i < seen.wetness_by_row.size(); ++i)
    forgive(seen.wetness_by_row[i], drawn.wetness_by_row[i], kWet);
  forgive(seen.camera.target, drawn.camera.target);
  forgive(seen.camera.distance, drawn.camera.distance, kPlace);
  forgive(seen.wheel_radius, drawn.wheel_radius, kPlace);
  if (seen.beside && drawn.beside) forgive(seen.beside->angle, drawn.beside->angle, kAngle);
  for (std::size_t n = 0; n < seen.hands.size(); ++n) forgive(seen.hands[n].at, drawn.hands[n].at);
  return seen == drawn;
}

}  // namespace onggi::view
