#include "engine/script/beating_up.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/beating.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr double kBeat = 0.34;    // s at pace 1, from blow to blow, as visitors' paddles
constexpr double kLies = 0.12;    // s at pace 1: how long the paddle stays on the wall
constexpr double kToSpeed = 1.0;  // s
constexpr double kSwing = 0.03;   // m: how far the paddle is drawn back
constexpr double kAway = 0.001;   // m between the hand's ball and the wall as the paddle strikes
constexpr double kBand = 1.0;     // faces that the paddle goes up in a turn of the wheel
constexpr double kLeast = 3.0;    // turns: a pot that is built begins as a low floor

const BeatingDef& law_of(const SceneDef& scene) {
  static const BeatingDef kUsual;
  return scene.beating ? *scene.beating : kUsual;
}

class BeatingUp final : public Script {
 public:
  explicit BeatingUp(const ScriptContext& context)
      : paddle_(context.scene, context.pace, nullptr),
        wheel_(std::min(PaddleUp::kSpeed * context.pace, context.scene.wheel.max_speed)) {
    const double bands = context.scene.clay.height / (kBand * law_of(context.scene).face);
    works_ = std::max(kLeast, bands) * 2.0 * portable::kPi / std::max(wheel_, 0.1);
  }

  Hands at(double t, const Clay& clay) noexcept override {
    Hands hands;
    hands.wheel_speed = wheel_;
    const double since = t - kToSpeed;
    if (since < 0.0 || t >= duration()) return hands;
    hands.hand[0] = paddle_.at(since, since / works_, clay);
    return hands;
  }

  double duration() const override { return kToSpeed + works_; }
  std::string_view phase(double t) const override { return t < kToSpeed ? "wheel" : "beat"; }

 private:
  PaddleUp paddle_;
  double wheel_;
  double works_ = 0.0;  // s
};

}  // namespace

PaddleUp::PaddleUp(const SceneDef& scene, double pace, const RingPlan* plan)
    : face_(law_of(scene).face),
      ball_(scene.tool.radius),
      beat_(kBeat / pace),
      lies_(kLies / pace),
      plan_(plan) {}

HandInput PaddleUp::at(double t, double share, const Clay& clay) noexcept {
  const double lowest = clay.floor_top() + kFromFoot * face_;
  const double highest = std::max(lowest, clay.rim_height() - kFromRim * face_);
  const double within = std::fmod(t, beat_);
  const bool lies = within < lies_;
  if (lies && !lay_) {
    height_ = lowest + (highest - lowest) * share;
    swings_ = plan_ != nullptr ? plan_->swings(clay, height_, std::nullopt) : Swings{};
  }
  lay_ = lies;
  // Drawn back, then on the wall.
  const double back =
      lies ? 0.0
           : 0.5 - 0.5 * portable::cos(2.0 * portable::kPi * (within - lies_) / (beat_ - lies_));
  const double height = lies ? height_ : lowest + (highest - lowest) * share;
  const int row = std::clamp(clay.first_row_above(height), 0, clay.rows() - 1);
  const double out =
      double{*std::ranges::max_element(clay.outer(row))} + ball_ + kAway + kSwing * back;
  HandInput hand;
  hand.position = {out * portable::cos(kHandAngle), height, out * portable::sin(kHandAngle)};
  hand.active = true;
  hand.paddle = true;
  hand.blow = lies;
  hand.swing = swings_.paddle;
  hand.anvil = swings_.anvil;
  return hand;
}

std::unique_ptr<Script> beat_wall(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<BeatingUp>(context);
}

}  // namespace onggi::script
