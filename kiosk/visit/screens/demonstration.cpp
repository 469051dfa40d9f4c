#include "kiosk/visit/screens/demonstration.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

using device::WallHold;

namespace {
constexpr double kWheel = 25.0;         // rad/s for a lump; slower for a wider pot,
constexpr double kRimSpeed = 2.0;       // m/s at the widest place at most
constexpr double kWetting = 0.7;        // s of the sponge, at first and at every third stroke
constexpr double kBreath = 0.5;         // s between two strokes
constexpr double kNearEnough = 0.0015;  // m
constexpr double kWidens = 0.005;       // m that a stroke widens: more would leave a ledge
constexpr double kSharp = 0.005;        // m that palms may leave on a neck
constexpr int kMostStrokes = 15;
constexpr double kRounding = 1 + 1e-6;
constexpr double kLongestStep = 0.1;  // s of a stroke from one frame to the next
constexpr double kStand = 2.5;        // s until the wheel has stopped
}  // namespace

Demonstration::Demonstration(const SceneForVisitor& wheel, bool left_handed)
    : wheel_(wheel),
      hands_({wheel.palm, wheel.palm_radius}, {0, wheel.tool_radius}),
      side_(left_handed ? -1 : 1) {
  if (wheel.rib) rib_.emplace(wheel.rib->tool, wheel.rib->length, wheel.rib->thickness);
  if (wheel.wire) wire_.emplace(*wheel.wire);
  if (wheel.trimmer) trimmer_.emplace(wheel.trimmer->tool, wheel.trimmer->radius);
}

void Demonstration::send(Vec3 right, loop::WheelCommands& wheel_commands) const {
  auto hands = hands_.input(right);
  if (stage_ == Stage::rib && rib_ && !rib_->done()) hands[0] = rib_->input(side_ * right);
  if (stage_ == Stage::foot && trimmer_ && !trimmer_->done())
    hands[0] = trimmer_->input(side_ * right);
  for (int n = 0; n < kMaxHands; ++n) wheel_commands.hand(n, hands[static_cast<std::size_t>(n)]);
}

void Demonstration::turn(double speed, loop::WheelCommands& wheel_commands) {
  if (std::abs(speed - requested_speed_) < 0.3 && speed != 0) return;
  requested_speed_ = speed;
  wheel_commands.wheel(side_ * speed);
}

void Demonstration::let_go(loop::WheelCommands& wheel_commands) {
  finger_.stop(hands_);
  hands_.lift();
  wheel_commands.water(water_ = false);
  for (int n = 0; n < kMaxHands; ++n) wheel_commands.hand(n, HandInput{});
}

bool Demonstration::rested(double dt, double seconds) {
  if (finger_.down() || hands_.active()) {
    stage_time_ = 0;
    return false;
  }
  stage_time_ += dt;
  return stage_time_ > seconds;
}

// Plan for what the hands can do: a palm rounds a sharp neck. If it would leave too much, use
// fingertips.
void Demonstration::take_hands(const Profile& target) {
  const WallHold::Part palm{wheel_.palm, wheel_.palm_radius}, finger{0, wheel_.tool_radius};
  worked_ = device::rolled(target, palm.radius);
  double left = 0;
  for (const ProfilePoint& at : worked_.points)
    if (at.height > 0.5 * target.height())
      left = std::max(left, at.outer - target.outer_at(at.height));
  const bool sharp = left > kSharp;
  if (sharp) worked_ = device::rolled(target, finger.radius);
  hands_.take_up(sharp ? finger : palm, finger);
}

void Demonstration::throw_on(double dt, const loop::WheelView& wheel, const Profile& target,
                             loop::WheelCommands& wheel_commands) {
  if (!rested(dt, kBreath)) return;
  if (water_) {
    if (stage_time_ < kBreath + kWetting) return;
    wheel_commands.water(water_ = false);
  } else if (strokes_ % 3 == 2 && wheel.status.feedback.wetness < 0.5) {
    wheel_commands.water(water_ = true);
    return;
  }
  const auto stroke = device::next_stroke(wheel.clay, worked_, kNearEnough, kWidens);
  if (stroke && strokes_ < kMostStrokes) {
    ++strokes_;
    finger_.begin(*stroke, side_, hands_, wheel.clay);
  } else {
    next_stage(wheel, target);
  }
}

void Demonstration::next_stage(const loop::WheelView& wheel, const Profile& target) {
  if (stage_ == Stage::throwing) {
    enter(Stage::foot);
    if (trimmer_) trimmer_->begin(wheel.clay, target);
  } else if (stage_ == Stage::foot) {
    enter(Stage::even);
    finger_.begin(device::last_stroke(wheel.clay, target), side_, hands_, wheel.clay);
  } else if (stage_ == Stage::even) {
    enter(Stage::rib);
    if (rib_) rib_->begin(wheel.clay);
  } else if (stage_ == Stage::rib) {
    enter(Stage::stand);
  }
}

void Demonstration::update(double dt, const loop::WheelView& wheel, const Profile& target,
                           Vec3 right, loop::WheelCommands& wheel_commands) {
  if (wheel.clay.rows() == 0 || done()) return;
  // The wheel's own seconds: on a busy machine it turns behind the screen. Hands that went by the
  // screen's, or leapt with each of its few frames, would leave a screw thread.
  const double turned = std::max(wheel.status.time - wheel_time_, 0.0);
  dt = std::min({dt, kRounding * turned, kLongestStep});
  wheel_time_ = wheel.status.time;
  if (stage_ == Stage::wire) {
    if (wire_->update(dt, wheel, right, wheel_commands)) enter(Stage::done);
    return;
  }
  if (stage_ == Stage::stand) {
    stage_time_ += dt;
    if (stage_time_ > kStand) enter(wire_ ? Stage::wire : Stage::done);
    return;
  }
  double widest = 0;
  for (int j = 0; j < wheel.clay.rows(); ++j) widest = std::max(widest, wheel.clay.mean_outer(j));
  turn(std::min({kWheel, wheel_.max_speed, kRimSpeed / std::max(widest, 0.01)}), wheel_commands);
  bool contact = false;
  for (const HandFeedback& felt : wheel.status.feedback.hand) contact = contact || felt.contact;

  if (stage_ == Stage::wet) {
    if (stage_time_ == 0) {
      take_hands(target);
      wheel_commands.water(true);
    }
    stage_time_ += dt;
    if (stage_time_ > kWetting + 0.8) {
      wheel_commands.water(false);
      enter(Stage::throwing);
    }
  } else if (stage_ == Stage::throwing) {
    throw_on(dt, wheel, target, wheel_commands);
  } else if (stage_ == Stage::foot) {
    if (trimmer_) trimmer_->follow(wheel.clay, target, dt);
    // Go up first: hands that went straight on from the foot would pass through the wall.
    if ((!trimmer_ || trimmer_->done()) && rested(dt, kBreath)) next_stage(wheel, target);
  } else if (stage_ == Stage::even) {
    if (rested(dt, kBreath)) next_stage(wheel, target);
  } else if (stage_ == Stage::rib) {
    if (rib_) rib_->follow(wheel.clay, dt);
    if (!rib_ || rib_->done()) next_stage(wheel, target);
  }
  finger_.draw(dt, hands_, wheel.clay);
  hands_.follow(wheel.clay, dt, contact);
  send(right, wheel_commands);
  if (stage_ == Stage::stand) turn(0, wheel_commands);
}

}  // namespace onggi::screens
