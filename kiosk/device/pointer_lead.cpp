#include "kiosk/device/pointer_lead.h"

#include <algorithm>

namespace onggi::device {

namespace {
constexpr double kFurthest = 0.25;  // Metres from the axis: clear of any clay.
}

void PointerLead::touch(const ClayView& clay, WallSide face, double height) {
  face_ = face;
  lowest_ = tool_radius_ * 0.3;
  // Inside, the floor is as low as a hand can go.
  if (face == WallSide::inside) lowest_ += clay.floor_top();
  highest_ = std::max(lowest_, clay.rim_height() + tool_radius_);
  height_ = std::clamp(height, lowest_, highest_);
  const double wall = clay.radius_at(height_, face);
  radius_ = std::max(0.0, face == WallSide::outside ? wall + tool_radius_ : wall - tool_radius_);
  active_ = true;
}

void PointerLead::grab(Vec2 at, const ClayView& clay, WallSide face) {
  sign_ = at.x < 0 ? -1 : 1;
  grab_x_ = at.x;
  touch(clay, face, at.y);
  grabbed_ = true;
}

void PointerLead::drag(Vec2 at) {
  if (!grabbed_) return;
  radius_ += sign_ * (at.x - grab_x_);
  grab_x_ = at.x;
  height_ = at.y;
  clamp();
}

void PointerLead::begin_by_keys(const ClayView& clay, WallSide face, double sign) {
  if (active_) return;
  sign_ = sign;
  touch(clay, face, clay.rim_height() * 0.5);
}

void PointerLead::move(double outward, double up) {
  if (!active_) return;
  radius_ += outward;
  height_ += up;
  clamp();
}

void PointerLead::clamp() {
  radius_ = std::clamp(radius_, 0.0, kFurthest);
  height_ = std::clamp(height_, lowest_, highest_);
}

HandInput PointerLead::input(Vec3 right) const {
  HandInput hand;
  hand.active = active_;
  hand.side = face_ == WallSide::outside ? SideWish::outside : SideWish::inside;
  hand.position = {right.x * sign_ * radius_, height_, right.z * sign_ * radius_};
  return hand;
}

}  // namespace onggi::device
