#include "kiosk/visit/screens/wheel_push.h"

#include <algorithm>
#include <cmath>

#include "engine/math/vec.h"

namespace onggi::screens {

using view::InputEvent;

namespace {
constexpr double kFullCircle = 2 * 3.14159265358979;
constexpr double kOffClay = 0.006;  // m round the clay
constexpr double kHeadSide = 0.05;  // m: so far in front of its edge lies the head's side, as seen
constexpr double kFront = 0.5;      // of the distance from the axis: nearer than that to the eye
constexpr double kMeant = 0.12;     // rad round, until it is a push
constexpr double kSmooth = 0.06;    // s
/// The clay covers this pixel, or nearly.
bool over(const ClayView& clay, float x, float y, const view::Camera& camera) {
  constexpr int kHeights = 24;
  for (int n = 0; n <= kHeights; ++n) {
    const double height = clay.rim_height() * n / kHeights;
    const auto at = camera.on_level(x, y, height);
    if (at && axis_distance(*at) < clay.radius_at(height, WallSide::outside) + kOffClay)
      return true;
  }
  return false;
}
// s: between two reports of a finger that moves, and before it lifts, there may be frames without
// one.
constexpr double kStill = 0.15;

}  // namespace

std::optional<double> WheelPush::angle_of(float x, float y, const view::Camera& camera) const {
  const auto at = camera.on_level(x, y, 0.0);
  if (!at || axis_distance(*at) < 1e-3) return std::nullopt;
  return std::atan2(at->z, at->x);
}

WheelPush::Takes WheelPush::pointer(const InputEvent& e, const view::Camera& camera, double radius,
                                    const ClayView& clay) {
  if (e.finger != 0) return Takes::nothing;
  if (e.kind == InputEvent::Kind::pointer_down) {
    lift();
    const auto at = camera.on_level(e.x, e.y, 0.0);
    if (!at || clay.rows() == 0 || over(clay, e.x, e.y, camera)) return Takes::nothing;
    Vec3 right, up, back;
    camera.basis(right, up, back);
    const double out = axis_distance(*at), nearer = at->x * back.x + at->z * back.z;
    if (out > radius + kHeadSide || nearer < kFront * out * length(Vec2{back.x, back.z}))
      return Takes::nothing;
    down_ = true;
    angle_ = std::atan2(at->z, at->x);
    turned_ = speed_ = still_ = 0;
    return Takes::wheel;
  }
  if (!down_) return Takes::nothing;
  if (e.kind == InputEvent::Kind::pointer_up) {
    lift();
    return Takes::wheel;
  }
  if (e.kind != InputEvent::Kind::pointer_move) return Takes::nothing;
  if (!turns_ && camera.on_axis_plane(e.x, e.y).y > 0.0) {
    lift();
    return Takes::lets_go;
  }
  if (const auto angle = angle_of(e.x, e.y, camera)) {
    turned_ += std::remainder(*angle - angle_, kFullCircle);
    angle_ = *angle;
  }
  if (!turns_ && std::abs(turned_) > kMeant) turns_ = true, turned_ = 0;
  return Takes::wheel;
}

std::optional<double> WheelPush::speed(double dt) {
  if (!turns_ || !(dt > 0)) return std::nullopt;
  still_ = turned_ == 0 ? still_ + dt : 0;
  if (turned_ == 0 && still_ < kStill) return speed_;
  const double now = turned_ / dt;
  turned_ = 0;
  speed_ += (now - speed_) * std::min(1.0, dt / kSmooth);
  return speed_;
}

}  // namespace onggi::screens
