#include "kiosk/wheel/device/pointer_lead.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kLeastSpread = 0.01;  // m on the pot: two fingers side by side
constexpr double kFurthest = 0.25;     // m from the axis: clear of any clay
constexpr double kSettingDown = 0.3;   // s: the hands must meet clay by then

double seconds_to(double reach, double height, double press, double rise) {
  return std::max(std::abs(reach) / press, std::abs(height) / rise);
}
}  // namespace

PointerLead::At PointerLead::within(At at) const {
  return {std::clamp(at.reach, 0.0, kFurthest), std::clamp(at.height, lowest_, highest_), at.light};
}

void PointerLead::touch(const ClayView& clay, Grip grip, double height) {
  hold_.take(clay, grip, height);
  drawn_.clear();
  active_ = true;
  grabbed_ = finishing_ = easing_ = false;
  upwards_ = 0;
  first_.reset();
  second_.reset();
  began_.reset();
  wall_ = 0;
  down_for_ = 0;
  lowest_ = hold_.lowest(clay);
  highest_ = hold_.highest(clay);
  at_ = within({0, height});
  at_.reach = hold_.face(clay, at_.height);
  pass_.begin(hold_, clay, at_.height);
  hands_ = hold_.stand(clay, at_.reach, at_.height);
}

void PointerLead::grab(Vec2 at, const ClayView& clay, Grip grip) {
  sign_ = at.x < 0 ? -1 : 1;
  touch(clay, grip, at.y);
  grabbed_ = true;
  scrolled_ = rests_ = across_ = 0;
  if (at.y < lowest_ || std::abs(at.x) < at_.reach - kInFront) began_ = heads_ = at;
  drag(at);
}

/// True while a pointer that went down in front of the pot has not shown that it works the wall.
bool PointerLead::on_its_way(Vec2 at) {
  if (!began_) return false;
  if (at.y < lowest_ && !second_) {
    heads_ = at;
    return true;
  }
  const double aside = std::abs(at.x - heads_.x), along = std::abs(at.y - heads_.y);
  bool works = false;
  if (std::max(aside, along) > kHeading) {
    works = along > kSteep * aside;
    heads_ = at;
  }
  if (second_ || works || std::abs(at.x) > at_.reach) began_.reset();
  return began_.has_value();
}

void PointerLead::drag(Vec2 at) {
  if (!grabbed_) return;
  if (!first_ || at != *first_) rests_ = 0;
  first_ = at;
  const bool light = on_its_way(at);
  if (!second_ && sign_ * at.x < 0) sign_ = -sign_, across_ = kAcross;
  double reach = std::abs(at.x), height = at.y;
  if (second_) {
    reach = std::max(reach, std::abs(second_->x));
    height = 0.5 * (height + second_->y);
    const double apart = length(*second_ - at);
    wall_ = thick_ * apart / spread_;
  }
  drawn_.push_back(within({reach + scrolled_, height, light}));
}

void PointerLead::pinch(std::optional<Vec2> at, const ClayView& clay) {
  if (!grabbed_ || !first_) return;
  if (at && !second_) {
    spread_ = std::max(length(*at - *first_), kLeastSpread);
    thick_ = WallHold::thickness(clay, at_.height);
  }
  second_ = at;
  if (!at) wall_ = 0;
  drag(*first_);
}

void PointerLead::release() {
  if (!grabbed_) return;
  if (began_ && first_) {  // it lifts where it was set down, or farther in: a press
    const bool press = first_->y >= lowest_ && std::abs(first_->x) < std::abs(began_->x) + kHeading;
    began_.reset();
    if (press) drag(*first_);
  }
  grabbed_ = false;
  second_.reset();
  finishing_ = true;
  left_ = kFinish;
}

void PointerLead::lift() {
  active_ = grabbed_ = finishing_ = easing_ = false;
  drawn_.clear();
}

void PointerLead::begin_by_keys(const ClayView& clay, Grip grip, double sign) {
  if (active_) return;
  sign_ = sign;
  touch(clay, grip, clay.rim_height() * 0.5);
}

void PointerLead::move(double outward, double up) {
  if (!active_) return;
  if (grabbed_) scrolled_ += outward;
  const At last = drawn_.empty() ? at_ : drawn_.back();
  drawn_.push_back(within({last.reach + outward, last.height + up}));
}

double PointerLead::behind() const {
  double sum = 0;
  At from = at_;
  for (const At& to : drawn_) {
    sum +=
        seconds_to(to.light ? 0.0 : to.reach - from.reach, to.height - from.height, kPress, kRise);
    from = to;
  }
  return sum;
}

void PointerLead::go_along(double seconds, double press, double rise) {
  while (!drawn_.empty() && seconds > 0) {
    const At to = drawn_.front();
    const double inward = to.light ? 0.0 : to.reach - at_.reach;
    const double needs = seconds_to(inward, to.height - at_.height, press, rise);
    const double share = needs <= seconds ? 1.0 : seconds / needs;
    at_.reach += share * inward;
    at_.light = to.light;
    at_.height += share * (to.height - at_.height);
    seconds -= needs;
    if (share == 1.0) drawn_.pop_front();
  }
}

/// After the stroke: continues along the wall and out of the clay. False when done.
bool PointerLead::come_out(const ClayView& clay, double dt) {
  if (!easing_) {
    if (upwards_ == 0 || hold_.solid(clay, at_.height)) return false;
    easing_ = true;
    drawn_.clear();
    pass_.ease_out();
  }
  at_.height += upwards_ * kRise * dt;
  if (pass_.out() || at_.height < lowest_ || at_.height > highest_) return false;
  pass_.go(hold_, clay, at_.height, at_.reach, dt);
  hands_ = hold_.stand(clay, reach(), at_.height, wall_);
  return true;
}

void PointerLead::follow(const ClayView& clay, double dt, bool pressing) {
  if (!active_ || clay.rows() == 0) return;
  down_for_ += dt;
  across_ -= dt;
  // Below the foot there is no clay to press: a finger may rest there before it goes out.
  if (began_ && first_ && first_->y >= lowest_ && (rests_ += dt) > kRest) {
    began_.reset();
    drag(*first_);
  }
  const bool in_clay = pressing || down_for_ < kSettingDown;
  const double hurry = std::max(1.0, behind() / kBehind);
  const bool solid = hold_.solid(clay, at_.height);
  if (solid && drawn_.size() > 1) drawn_.erase(drawn_.begin(), drawn_.end() - 1);
  const double was = at_.height;
  go_along(dt * hurry, solid ? kSolid : in_clay ? kPress : kAir, in_clay ? kRise : kAir);
  if (at_.height != was) upwards_ = at_.height > was ? 1 : -1;
  lowest_ = hold_.lowest(clay);
  highest_ = hold_.highest(clay);
  if (finishing_ && (drawn_.empty() || (left_ -= dt) < 0)) {
    if (!come_out(clay, dt)) lift();
    return;
  }
  at_ = within(at_);
  pass_.go(hold_, clay, at_.height, at_.light ? std::nullopt : std::optional(at_.reach), dt);
  if (at_.light) at_.reach = pass_.reach();
  hands_ = hold_.stand(clay, reach(), at_.height, wall_);
}

std::array<HandInput, kMaxHands> PointerLead::input(Vec3 right) const {
  std::array<HandInput, kMaxHands> hands;
  const auto place = [&](HandInput& hand, SideWish side, const WallHold::Stand& stand) {
    hand.active = active_ && stand.there && across_ <= 0;
    hand.side = side;
    hand.tool = stand.part.tool;
    const double away = sign_ * stand.radius;
    hand.position = {right.x * away, stand.height, right.z * away};
  };
  const bool both = hold_.grip() != Grip::inside;
  if (both) place(hands[0], SideWish::outside, hands_.outside);
  place(hands[both ? 1 : 0], SideWish::inside, hands_.inside);
  return hands;
}

}  // namespace onggi::device
