#include "engine/script/forming.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/moisture.h"
#include "engine/math/portable.h"
#include "engine/script/choreography.h"
#include "engine/script/former.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr double kRough = 0.036;  // m/s along the wall
constexpr double kFine = 0.015;
// A sphere of 8 mm that rises 2 mm a turn leaves ridges of 2^2 / (8 * 8) = 0.06 mm: visible
// throwing lines that a finger does not feel.
constexpr double kFinish = 0.008;
constexpr double kWheelRough = 18.0;  // rad/s: 172 rpm
constexpr double kWheelFine = 22.0;   // 210 rpm

// Plays keys back.
class PlannedScript final : public Script {
 public:
  PlannedScript(std::vector<Key> keys, double tool_radius)
      : keys_(std::move(keys)), radius_(tool_radius) {}

  Hands at(double t, const Clay&) noexcept override {
    const auto between = keys_.at(t);
    const Key& a = between.from;
    const Key& b = between.to;
    const double share = between.share;
    const Vec2 place = a.place + share * (b.place - a.place);
    const bool over = t >= duration();
    Hands hands;
    hands.hand[0].position = {place.x * cos_, place.y, place.x * sin_};
    hands.hand[0].active = a.active && !over;
    hands.hand[0].side = a.side == WallSide::inside ? SideWish::inside : SideWish::outside;
    if (a.grip > 0.0) {
      const double room = a.grip + share * ((b.grip > 0.0 ? b.grip : a.grip) - a.grip);
      const double inner = place.x - 2.0 * radius_ - room;
      hands.hand[1] = {
          {inner * cos_, place.y, inner * sin_}, hands.hand[0].active, SideWish::inside};
    }
    hands.wheel_speed = (over ? b : a).wheel_speed;
    hands.water = a.water && !over;
    return hands;
  }

  double duration() const override { return keys_.duration(); }

  std::string_view phase(double t) const override { return keys_.phase(t); }

 private:
  Keyed<Key> keys_;
  double radius_;
  double cos_ = portable::cos(kHandAngle);
  double sin_ = portable::sin(kHandAngle);
};

// 0 below `low`, 1 above `high`, smooth between.
double rise(double h, double low, double high) {
  const double t = std::clamp((h - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

void begin(Choreography& hand) {
  hand.wheel(kWheelRough);
  hand.wait(1.0);
}

// A soft, wide pot spreads when it spins fast. At this share of its strength, half wet, it still
// carries its weight.
double steady_wheel(const SceneDef& scene, const Profile& target) {
  if (!scene.slump) return scene.wheel.max_speed;
  constexpr double kShare = 0.5;
  constexpr double kRoot3 = 1.7320508075688772;
  const double weak = scene.moisture ? effects::strength(*scene.moisture, 0.5) : 1.0;
  const double hoop = kShare * kRoot3 * scene.slump->yield_stress * weak;
  const double speed = std::sqrt(hoop / scene.slump->density) / target.max_radius();
  return std::min(scene.wheel.max_speed, speed);
}

// The target's own outline: widen and narrow quickly, then slowly over each face. Returns the
// seconds of the slow passes, which haste does not shorten.
double go_along(Former& former, Choreography& hand, const SceneDef& scene, const Profile& target) {
  // As many turns on the way up, however slowly the wheel must turn.
  const double slower = std::min(1.0, steady_wheel(scene, target) / kWheelFine);
  double slow = 0.0;
  const auto finish = [&](WallSide side, std::string_view phase) {
    const double before = hand.time_on_clay();
    former.finish(side, phase, kFinish * slower);
    slow += hand.time_on_clay() - before;
  };
  former.set_goal([&](double h) { return target.outer_at(h); });
  former.open("open", kRough);
  hand.wheel(kWheelFine);
  // The outside cannot widen what is still too narrow here.
  finish(WallSide::inside, "pull");
  former.narrow("shape", kRough);
  finish(WallSide::outside, "finish");
  return slow;
}

// A visitor watches for about this long: small pots get slower passes, tall ones quicker.
std::vector<Key> follow_in_time(const ScriptContext& context) {
  constexpr double kWanted = 112.0;  // s at pace 1
  double haste = 1.0;
  for (int round = 0;; ++round) {
    Choreography hand(context.pace, steady_wheel(context.scene, *context.target), context.seed);
    Former former(context.scene, hand, haste);
    begin(hand);
    const double slow = go_along(former, hand, context.scene, *context.target);
    former.rest();
    if (round == 1) return hand.finish();
    const double quick = hand.time_on_clay() - slow;
    const double left = std::max(kWanted / context.pace - (hand.time() - quick), 0.4 * quick);
    // Beyond 2.4 times the usual speed the clay does not follow the finger.
    haste = std::clamp(quick / left, 0.5, std::max(0.5, 2.4 / context.pace));
  }
}

}  // namespace

// An even cylinder.
void turn_true(Choreography&, Former& former, const SceneDef& scene) {
  former.set_goal([&](double) { return 0.94 * scene.clay.outer_radius; });
  former.narrow("centre", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// A narrow neck over a straight body.
void narrow_neck(Choreography&, Former& former, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  former.set_goal([&](double h) {
    const double t = h / clay.height;
    return clay.outer_radius * (0.97 - 0.45 * rise(t, 0.5, 0.78) + 0.08 * rise(t, 0.85, 1.0));
  });
  former.narrow("collar", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// A barrel, pushed out from inside; the solid foot stays.
void push_barrel(Choreography&, Former& former, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  former.set_goal([&](double h) {
    const double wide = portable::sin(portable::kPi * rise(h / clay.height, 0.02, 1.0));
    return std::min(clay.outer_radius * (0.95 + 0.55 * wide), 0.95 * clay.radius_max);
  });
  former.open("belly", kRough);
  former.narrow("shape", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// A foot, and a wall that flares to the rim.
void flare_wall(Choreography&, Former& former, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double rim = std::min(2.0 * clay.outer_radius, 0.95 * clay.radius_max);
  former.set_goal([&](double h) {
    const double t = h / clay.height;
    return 0.85 * clay.outer_radius + (rim - 0.85 * clay.outer_radius) * std::sqrt(t) * t;
  });
  former.open("open", kRough);
  former.narrow("foot", kRough);
  former.smooth(WallSide::outside, "smooth", kFine);
}

// One fingertip held to a straight wall.
void hold_finger(Choreography&, Former& former, const SceneDef& scene) {
  const ClayDef& clay = scene.clay;
  const double radius = scene.tool.radius;
  former.set_goal([&](double h) {
    const double dy = std::fabs(h - 0.6 * clay.height);
    const double cut = std::sqrt(std::max(0.0, radius * radius - dy * dy)) - 0.2 * radius;
    return clay.outer_radius - std::max(0.0, cut);
  });
  former.narrow("groove", 0.2 * kRough);
}

std::unique_ptr<Script> play(const ScriptContext& context, const ToolInHand&, Forming& moves) {
  Choreography hand(context.pace, context.scene.wheel.max_speed, context.seed);
  Former former(context.scene, hand);
  begin(hand);
  moves(hand, former, context.scene);
  former.rest();
  return std::make_unique<PlannedScript>(hand.finish(), context.scene.tool.radius);
}

std::unique_ptr<Script> follow(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<PlannedScript>(follow_in_time(context), context.scene.tool.radius);
}

}  // namespace onggi::script
