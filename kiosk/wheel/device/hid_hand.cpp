#include "kiosk/wheel/device/hid_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/math/unit.h"

namespace onggi::device {

namespace {

constexpr double kFurthestOut = 0.25;  // m from the axis: clear of all clay
constexpr double kHighest = 0.45;      // m
constexpr double kGoesHome = 3.0;      // s after which a puck starts at home again
constexpr double kPickedUp = 0.75;     // rad/s: more than from a shaken table
constexpr double kTilted = 0.1;        // rad/s, for a hand that is already in use
constexpr double kStale = 0.1;         // s: a pushed puck reports at least every 16 ms

/// 0 within `dead`, then rising to 1, gently at first.
double shaped(double value, double dead) {
  const double size = std::fabs(value);
  if (!(size > dead)) return 0.0;
  const double share = std::min(1.0, (size - dead) / (1.0 - dead));
  return std::copysign(0.5 * share * (1.0 + share), value);
}

Vec3 shaped(Vec3 v, double dead) {
  return {shaped(v.x, dead), shaped(v.y, dead), shaped(v.z, dead)};
}

/// Implicit Euler towards `to`: never past it, at any dt.
Vec3 towards(Vec3 from, Vec3 to, double time, double dt) {
  return from + (to - from) * (dt / (time + dt));
}

Vec3 turned(Vec3 v, Vec3 by) {
  // First-order rotation, then back to the old length: a tick turns it by thousandths.
  return unit(v + cross(by, v));
}

}  // namespace

HidHand::HidHand(std::shared_ptr<HidLink> link, bool left_handed)
    : link_(std::move(link)),
      def_(link_->def()),
      home_(def_.home),
      pushes_(info_of(link_->kind()).force) {
  // A tool that moves `scale` times as far as the handle pulls the handle that much harder.
  limits_.stiffness = def_.coupling() / def_.scale;
  limits_.mass = def_.body.mass / def_.scale;
  limits_.own_damping = def_.own_damping() / def_.scale;
  limits_.max_force = link_->cap();
  limits_.delay = def_.body.delay;
  // Mirror the start position and the middle of the workspace. The device's own right stays right.
  if (left_handed) {
    home_.x = -home_.x;
    def_.middle.x = -def_.middle.x;
  }
  at_ = home_;
}

Vec3 HidHand::handle_place(double dt) noexcept {
  const Vec3 place = def_.smoothing > 0.0 ? join_.at(sample_.place, sample_.reports, sample_.at_ns,
                                                     link_->time_ns(), dt, def_.smoothing)
                                          : sample_.place;
  const Vec3 mapped = home_ + def_.scale * (to_studio(def_, place) - def_.middle) + clutch_offset_;
  const bool clutch = (sample_.buttons & kClutch) != 0;
  if (clutch || clutched_) {
    // Hold the tool. The handle's motion becomes the clutch's offset.
    clutch_offset_ = clutch_offset_ + at_ - mapped;
    clutched_ = clutch;
    return at_;
  }
  return mapped;
}

Vec3 HidHand::glide(double dt) noexcept {
  if (idle_time_ > kGoesHome) {
    at_ = home_;
    speed_ = {};
    handle_ = {};
    roll_ = 0.0;
  }
  const Vec3 asked =
      idle_time_ > 0.0 ? Vec3{} : def_.speed * to_studio(def_, shaped(sample_.push, def_.dead));
  speed_ = towards(speed_, asked, def_.smoothing, dt);
  Vec3 to = at_ + dt * speed_;
  to.y = std::clamp(to.y, 0.0, kHighest);
  const double out = axis_distance(to);
  if (out > kFurthestOut) {
    to.x *= kFurthestOut / out;
    to.z *= kFurthestOut / out;
  }
  return to;
}

void HidHand::turn_tool(double dt, HandInput& hand) noexcept {
  // A puck's twist sets the speed of turning; a tilted device turns the tool with it.
  const Vec3 speed = def_.turn_speed * to_studio(def_, shaped(sample_.twist, 2.0 * def_.dead)) +
                     to_studio(def_, sample_.turning);
  if (speed != Vec3{} && idle_time_ <= 0.0) {
    if (handle_ == Vec3{}) handle_ = {0.0, 1.0, 0.0};
    handle_ = turned(handle_, dt * speed);
    roll_ += dt * dot(speed, handle_);
  }
  hand.handle = handle_;
  hand.roll = roll_;
}

bool HidHand::in_use(double dt) noexcept {
  if (sample_.lost || sample_.reports == 0) return false;
  if (sample_.has_place) return sample_.held;
  const bool stale = static_cast<double>(link_->time_ns() - sample_.at_ns) > kStale * 1e9;
  const Vec3 push = shaped(sample_.push, def_.dead), twist = shaped(sample_.twist, 2.0 * def_.dead);
  const bool turns =
      length(sample_.turning) > (idle_time_ < def_.lifts_after ? kTilted : kPickedUp);
  idle_time_ = !stale && (push != Vec3{} || twist != Vec3{} || turns) ? 0.0 : idle_time_ + dt;
  return idle_time_ < def_.lifts_after;
}

HandInput HidHand::read(double dt) noexcept {
  if (link_->by_hand()) link_->pump(dt);
  link_->newest(sample_);
  HandInput hand;
  hand.active = in_use(dt);
  at_ = sample_.has_place ? handle_place(dt) : glide(dt);
  used_ = hand.active;
  moves_.store(used_, std::memory_order_relaxed);
  if (!used_) haptics_.release();
  if (!pushes_ || !used_)
    tool_ = at_;
  else if (!clutched_)
    tool_ = haptics_.tool(at_, dt, limits_);
  hand.position = tool_;
  turn_tool(dt, hand);
  return hand;
}

double HidHand::age() const noexcept {
  if (sample_.lost || sample_.reports == 0) return -1.0;
  return static_cast<double>(link_->time_ns() - sample_.at_ns) * 1e-9;
}

void HidHand::feel(const HandFeedback& feedback) noexcept {
  ++wish_.ticks;
  const double share = clutched_ ? 0.0 : share_.load(std::memory_order_relaxed);
  Vec3 force = share * feedback.force;
  if (pushes_) {
    if ((feedback.blow > 0.0) != struck_) haptics_.strike(feedback.blow, feedback.blow_out);
    struck_ = feedback.blow > 0.0;
    force = used_ && !clutched_ ? haptics_.feel(feedback.touch, share, limits_) : Vec3{};
    // The gate gets it anyway: it stops the force at once, and counts the fault.
    if (!is_finite(feedback.touch.push)) force = feedback.touch.push;
  }
  wish_.force = to_device(def_, force);
  wish_.strength = length(force);
  wish_.contact = feedback.contact && share > 0.0;
  link_->wish(wish_);
}

}  // namespace onggi::device
