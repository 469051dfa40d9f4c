#include "kiosk/visit/screens/instead_of_hands.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/moisture.h"
#include "engine/scene/hand_view.h"

namespace onggi::screens {

namespace {
constexpr std::string_view kCoilTool = "coil";
constexpr double kMostBeating = 4.0;  // rad/s: at three blows a second, five in a turn
constexpr double kOnceUp = 9.0;       // s, from the foot to the rim
}  // namespace

bool InsteadOfHands::has(std::string_view tool) const {
  return (tool == kCoilTool && coil_.built()) ||
         (tool == scene::kPaddle && !two_ && desk_.wheel().beating);
}

void InsteadOfHands::take_up(std::string_view tool, WheelSpeed& speed) {
  paddle_.reset();
  coil_.hold(tool == kCoilTool && has(tool), speed);
  if (tool != scene::kPaddle || !has(tool)) return;
  const SceneForVisitor wheel = desk_.wheel();
  paddle_.emplace(wheel.beating->face, wheel.tool_radius);
  aimed_ = {};
  desk_.world.wheel_commands->hold(loop::InHand::paddle);
  speed.slow(WheelSpeed::Slowly::beating, kMostBeating, desk_);
}

void InsteadOfHands::lift() {
  coil_.lift();
  if (paddle_) paddle_->lift();
}

bool InsteadOfHands::pointer(const view::InputEvent& e, const view::Camera& camera) {
  return paddle_ ? paddle_->pointer(e) : coil_.hand().pointer(e, camera, desk_.world.wheel->clay);
}

void InsteadOfHands::move_by_keys(double side, double outward, double up) {
  paddle_ ? paddle_->move_by_keys(side, up, desk_.world.wheel->clay)
          : coil_.hand().move_by_keys(side, outward);
}

void InsteadOfHands::follow(double dt) { paddle_ ? paddle_->follow(dt) : coil_.follow(dt); }

void InsteadOfHands::aim() {
  const bool beats = paddle_ && coil_.plan() != nullptr;
  worst_ = beats && to_beat()
               ? coil_.plan()->worst(desk_.world.wheel->clay,
                                     worst_ ? std::optional(worst_->height) : std::nullopt)
               : std::nullopt;
  if (!beats) return;
  const ClayView& clay = desk_.world.wheel->clay;
  const Vec3 hand = desk_.status.hands.hand[0].position;
  const script::Swings swings = coil_.plan()->swings(
      clay, hand.y, std::atan2(hand.z, hand.x) - clay.angle, strength_at(hand.y));
  if (swings != aimed_) desk_.world.wheel_commands->swing(swings);
  aimed_ = swings;
}

double InsteadOfHands::strength_at(double height) const {
  const auto& moisture = desk_.wheel().moisture;
  if (!moisture) return 1.0;
  const ClayView& clay = desk_.world.wheel->clay;
  const auto rows = static_cast<double>(clay.wet.size());
  const double share = std::clamp(height / std::max(clay.rim_height(), 1e-3), 0.0, 1.0);
  const double wet = clay.wet.empty()
                         ? desk_.status.feedback.wetness
                         : double{clay.wet[static_cast<std::size_t>(share * (rows - 1.0))]};
  return effects::strength(*moisture, wet);
}

bool InsteadOfHands::to_beat() const {
  return coil_.plan() != nullptr && coil_.plan()->to_beat(desk_.world.wheel->clay);
}

std::optional<BuiltPot> InsteadOfHands::state() const {
  if (coil_.plan() == nullptr) return std::nullopt;
  BuiltPot built{coil_.lacks_a_ring(), to_beat()};
  if (worst_) built.worst = Hint::Press{worst_->height, worst_->inward};
  built.beaten = coil_.plan()->beaten(desk_.world.wheel->clay);
  return built;
}

void InsteadOfHands::send(const view::Camera& camera) const {
  if (!paddle_) return coil_.send(camera);
  desk_.world.wheel_commands->hand(0, paddle_->input(camera, desk_.world.wheel->clay));
  desk_.world.wheel_commands->hand(1, {});
}

void InsteadOfHands::work_by_itself(double side) {
  paddle_ ? paddle_->beat_up(side, kOnceUp) : coil_.lay_a_ring(side);
}

Button InsteadOfHands::button(Button show) const {
  if (!paddle_) return coil_.button(show);
  if (by_itself()) show.look = Look::chosen;
  return show;
}

}  // namespace onggi::screens
