#include "kiosk/visit/screens/coil_hand.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

using view::InputEvent;

namespace {
constexpr double kPressed =
    0.01;                         // coils: it rests on the rim, and comes clear of a ring it closed
constexpr double kMeant = 2.5;    // coils from the rim's middle: a finger farther off moves nothing
constexpr double kRound = 0.7;    // of the rim's radius: a finger that goes so far goes round
constexpr double kOnTop = 0.001;  // m inside the wall's edge: farther out it would slip off
constexpr double kRisen = 0.5;    // coils that the rim rises as a ring closes
}  // namespace

double CoilHand::middle_of_rim(const ClayView& clay, double diameter) {
  const int top = clay.rows() - 1;
  const double outer = clay.mean_outer(top), inner = clay.mean_inner(top);
  return inner > 0.0 ? 0.5 * (outer + inner) : std::max(outer - 0.5 * diameter, 0.0);
}

bool CoilHand::pointer(const InputEvent& e, const view::Camera& camera, const ClayView& clay) {
  if (e.finger != 0) return false;
  const double x = camera.on_axis_plane(e.x, e.y).x, middle = middle_of_rim(clay, diameter_);
  switch (e.kind) {
    case InputEvent::Kind::pointer_down:
      lift();
      active_ = grabbed_ = true;
      round_ = false;
      began_ = x;
      side_ = x < 0 ? -1.0 : 1.0;
      break;
    case InputEvent::Kind::pointer_move:
      if (!grabbed_) return false;
      round_ = round_ || std::abs(x - began_) > kRound * middle;
      break;
    case InputEvent::Kind::pointer_up:
      if (!grabbed_) return false;
      lift();
      return true;
    default:
      return false;
  }
  px_ = e.x, py_ = e.y;
  radius_ = std::abs(std::abs(x) - middle) < kMeant * diameter_ ? std::abs(x) : middle;
  return true;
}

void CoilHand::move_by_keys(double side, double outward, const ClayView& clay) {
  if (!active_) {
    active_ = true;
    round_ = false;
    side_ = side;
    radius_ = middle_of_rim(clay, diameter_);
  } else {
    const double middle = middle_of_rim(clay, diameter_);
    radius_ = std::clamp(radius_ + outward, middle - diameter_, middle + diameter_);
  }
}

void CoilHand::lay_a_ring(double side, double radius, const ClayView& clay) {
  lift();
  active_ = true;
  round_ = false;
  side_ = side;
  radius_ = radius;
  ends_ = clay.rim_height() + kRisen * diameter_;
}

bool CoilHand::follow(const ClayView& clay) {
  if (!ends_ || clay.rim_height() < *ends_) return false;
  lift();
  return true;
}

HandInput CoilHand::input(const view::Camera& camera, const ClayView& clay) const {
  HandInput hand;
  hand.active = active_ && clay.rows() > 0;
  if (!hand.active) return hand;
  const int top = clay.rows() - 1;
  const double height = clay.rim_height() + (0.5 - kPressed) * diameter_;
  const double middle = middle_of_rim(clay, diameter_);
  Vec3 right, up, back;
  camera.basis(right, up, back);
  Vec3 way = side_ * right;
  const double least = clay.mean_inner(top) + kOnTop, most = clay.mean_outer(top) - kOnTop;
  double radius = least < most ? std::clamp(radius_, least, most) : middle;
  if (const auto there = camera.on_level(px_, py_, height); round_ && there) {
    const double away = std::max(axis_distance(*there), 1e-6);
    way = {there->x / away, 0.0, there->z / away};
    radius = middle;
  }
  hand.position = {radius * way.x, height, radius * way.z};
  return hand;
}

}  // namespace onggi::screens
