#include "kiosk/wheel/device/pointer_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::device {

namespace {
// s: on an uneven pot a tool is clear for part of a turn, but is still pressing.
constexpr double kStillPressing = 0.3;
constexpr double kComingOff = 0.01;  // m/s away from the wall
}  // namespace

void PointerHand::lead(const HandInput& target) noexcept {
  target_ = target;
  if (target.active) return;
  // A hand at an invalid position (a reported fault) has nothing to come off from.
  const bool somewhere = std::isfinite(at_.x + at_.y + at_.z);
  if (down_ && somewhere && pressed_ago_ < kStillPressing) leaving_ = def_.letting_go;
  down_ = false;
}

void PointerHand::feel(const HandFeedback& felt) noexcept {
  if (felt.contact) pressed_ago_ = 0;
}

HandInput PointerHand::come_off(double dt) noexcept {
  if (leaving_ <= 0) {
    at_ = target_.position;
    return target_;
  }
  leaving_ -= dt;
  const double away = axis_distance(at_);
  const double off = held_.side == SideWish::inside ? -kComingOff * dt : kComingOff * dt;
  if (away > 1e-6) {
    const double scale = std::max(0.0, away + off) / away;
    at_ = {at_.x * scale, at_.y, at_.z * scale};
  }
  HandInput hand = held_;
  hand.position = at_;
  return hand;
}

HandInput PointerHand::read(double dt) noexcept {
  pressed_ago_ += dt;
  if (!target_.active) return come_off(dt);
  HandInput hand = target_;
  leaving_ = 0;
  if (!std::exchange(down_, true)) {
    at_ = target_.position;
    pressed_ago_ = 0;  // it is set down on the clay
    return held_ = hand;
  }
  // Implicit Euler of x' = (target - x) / settle_time: no overshoot at any dt, and without exp, so
  // the bits are the same on every machine. First order is enough, because the pointer itself is
  // only accurate to a pixel.
  Vec3 move = (target_.position - at_) * (dt / (def_.settle_time + dt));
  const auto within = [](double value, double limit) { return std::clamp(value, -limit, limit); };
  const double away = axis_distance(at_);
  if (pressed_ago_ < kStillPressing && away > 1e-6) {
    const Vec3 out{at_.x / away, 0.0, at_.z / away};
    const double along = dot(move, out);
    Vec3 rest = move - along * out;
    const double limit = def_.rise_speed * dt, distance = length(rest);
    if (distance > limit) rest = rest * (limit / distance);
    move = rest + within(along, def_.press_speed * dt) * out;
  }
  const double limit = def_.max_speed * dt, distance = length(move);
  if (distance > limit) move = move * (limit / distance);
  hand.position = at_ += move;
  return held_ = hand;
}

}  // namespace onggi::device
