#include "engine/script/beating_up.h"

#include <algorithm>
#include <cmath>

#include "engine/clay/clay.h"
#include "engine/effects/beating.h"
#include "engine/math/portable.h"
#include "engine/script/keyed.h"

namespace onggi::script {
namespace {

constexpr double kBeatingSpeed = 2.0;  // rad/s at pace 1
constexpr double kBeat = 0.4;          // s at pace 1, from blow to blow
constexpr double kLies = 0.15;         // s at pace 1: how long the paddle stays on the wall
constexpr double kToSpeed = 1.0;       // s
constexpr double kSwing = 0.03;        // m: how far the paddle is drawn back
constexpr double kAway = 0.001;    // m between the hand's ball and the wall as the paddle strikes
constexpr double kBand = 1.0;      // faces that the paddle goes up in a turn of the wheel
constexpr double kLeast = 3.0;     // turns: a pot that is built begins as a low floor
constexpr double kFromFoot = 0.5;  // faces above the floor

class BeatingUp final : public Script {
 public:
  explicit BeatingUp(const ScriptContext& context)
      : face_((context.scene.beating ? *context.scene.beating : BeatingDef{}).face),
        ball_(context.scene.tool.radius),
        wheel_(std::min(kBeatingSpeed * context.pace, context.scene.wheel.max_speed)),
        beat_(kBeat / context.pace),
        lies_(kLies / context.pace) {
    const double turns = std::max(kLeast, context.scene.clay.height / (kBand * face_));
    works_ = turns * 2.0 * portable::kPi / std::max(wheel_, 0.1);
  }

  Hands at(double t, const Clay& clay) noexcept override {
    Hands hands;
    hands.wheel_speed = wheel_;
    const double since = t - kToSpeed;
    if (since < 0.0 || t >= duration()) return hands;
    const double lowest = clay.floor_top() + kFromFoot * face_;
    const double highest = std::max(lowest, clay.rim_height() - 0.5 * face_);
    const double height = lowest + (highest - lowest) * since / works_;
    const double within = std::fmod(since, beat_);
    // Drawn back, then on the wall.
    const double back =
        within < lies_
            ? 0.0
            : 0.5 - 0.5 * portable::cos(2.0 * portable::kPi * (within - lies_) / (beat_ - lies_));
    const int row = std::clamp(clay.first_row_above(height), 0, clay.rows() - 1);
    const double out =
        double{*std::ranges::max_element(clay.outer(row))} + ball_ + kAway + kSwing * back;
    HandInput& hand = hands.hand[0];
    hand.position = {out * portable::cos(kHandAngle), height, out * portable::sin(kHandAngle)};
    hand.active = true;
    hand.paddle = true;
    hand.blow = within < lies_;
    hand.anvil = true;
    return hands;
  }

  double duration() const override { return kToSpeed + works_; }
  std::string_view phase(double t) const override { return t < kToSpeed ? "wheel" : "beat"; }

 private:
  double face_, ball_, wheel_;
  double beat_, lies_;  // s
  double works_ = 0.0;  // s
};

}  // namespace

std::unique_ptr<Script> beat_wall(const ScriptContext& context, const ToolInHand&) {
  return std::make_unique<BeatingUp>(context);
}

}  // namespace onggi::script
