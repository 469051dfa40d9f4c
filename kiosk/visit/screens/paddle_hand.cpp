#include "kiosk/visit/screens/paddle_hand.h"

#include <algorithm>
#include <cmath>

#include "engine/script/beating_up.h"

namespace onggi::screens {

using view::InputEvent;

namespace {

constexpr double kOff = 0.002;      // m between the hand's ball and the wall
constexpr double kAsidePot = 0.03;  // m beside the pot: a finger farther off beats nothing
constexpr double kAtSide = 0.75;    // of the radius: where keys beat, so that the paddle is seen

/// Farthest that the wall reaches at `height`, m from the axis.
double widest(const ClayView& clay, double height) {
  int row = 0;
  while (row + 1 < clay.rows() && clay.row_height(row + 1) <= height) ++row;
  return double{*std::ranges::max_element(clay.outer(row))};
}

}  // namespace

double PaddleHand::lowest(const ClayView& clay) const {
  return std::min(clay.floor_top() + script::PaddleUp::kFromFoot * face_, clay.rim_height());
}

double PaddleHand::highest(const ClayView& clay) const {
  return std::max(lowest(clay), clay.rim_height() - script::PaddleUp::kFromRim * face_);
}

bool PaddleHand::pointer(const InputEvent& e) {
  if (e.finger != 0) return false;
  switch (e.kind) {
    case InputEvent::Kind::pointer_down:
      lift();
      active_ = grabbed_ = true;
      break;
    case InputEvent::Kind::pointer_move:
      if (!grabbed_) return false;
      break;
    case InputEvent::Kind::pointer_up:
      if (!grabbed_) return false;
      lift();
      return true;
    default:
      return false;
  }
  px_ = e.x, py_ = e.y;
  return true;
}

void PaddleHand::move_by_keys(double side, double up, const ClayView& clay) {
  const bool began = !active_ || left_;
  if (began) lift();
  active_ = true;
  side_ = side;
  up_ = began ? 0.5 * (lowest(clay) + highest(clay)) : up_ + up;
  up_ = std::clamp(up_, lowest(clay), highest(clay));
}

void PaddleHand::beat_up(double side, double seconds) {
  lift();
  active_ = true;
  side_ = side;
  whole_ = seconds;
  left_ = stopped_ > 0 ? std::min(stopped_, seconds) : seconds;
}

void PaddleHand::follow(double dt) {
  if (!left_) return;
  *left_ -= dt;
  stopped_ = std::max(*left_, 0.0);
  if (*left_ <= 0) lift();
}

HandInput PaddleHand::input(const view::Camera& camera, const ClayView& clay) const {
  HandInput hand;
  if (!active_ || clay.rows() == 0) return hand;
  Vec3 right, up, back;
  camera.basis(right, up, back);
  const double level = length(Vec2{back.x, back.z});
  const Vec3 nearer = (1.0 / level) * Vec3{back.x, 0.0, back.z};
  double height = 0, across = kAtSide * side_;
  if (grabbed_) {
    const Vec2 at = camera.on_axis_plane(px_, py_);
    const double wide = widest(clay, at.y);
    if (std::abs(at.x) > wide + kAsidePot || at.y > clay.rim_height() + kAsidePot) return hand;
    across = std::clamp(at.x / wide, -1.0, 1.0);
    // The wall in front is nearer to the eye than the axis, and so higher on the same line.
    height = at.y + wide * std::sqrt(1.0 - across * across) * back.y / level;
  } else {
    height = left_ ? lowest(clay) + (1 - *left_ / whole_) * (highest(clay) - lowest(clay)) : up_;
  }
  height = std::clamp(height, lowest(clay), highest(clay));
  const double out = widest(clay, height) + ball_ + kOff;
  hand.position = out * (across * right + std::sqrt(1.0 - across * across) * nearer);
  hand.position.y = height;
  hand.side = SideWish::outside;
  hand.active = true;
  return hand;
}

}  // namespace onggi::screens
