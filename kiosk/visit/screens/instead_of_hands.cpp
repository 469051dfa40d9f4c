#include "kiosk/visit/screens/instead_of_hands.h"

#include "engine/scene/hand_view.h"

namespace onggi::screens {

namespace {
constexpr std::string_view kCoilTool = "coil";
constexpr double kBeating = 4.0;  // rad/s at most: at three blows a second, five in a turn
constexpr double kOnceUp = 9.0;   // s, from the foot to the rim
}  // namespace

bool InsteadOfHands::has(std::string_view tool) const {
  return (tool == kCoilTool && coil_.built()) ||
         (tool == scene::kPaddle && !two_ && desk_.wheel().face);
}

void InsteadOfHands::take_up(std::string_view tool, WheelSpeed& speed) {
  paddle_.reset();
  coil_.hold(tool == kCoilTool && has(tool), speed);
  if (tool != scene::kPaddle || !has(tool)) return;
  const SceneForVisitor wheel = desk_.wheel();
  paddle_.emplace(*wheel.face, wheel.tool_radius);
  desk_.world.wheel_commands->hold(loop::InHand::paddle);
  speed.lay(true, kBeating, desk_);
}

void InsteadOfHands::lift() {
  coil_.lift();
  if (paddle_) paddle_->lift();
}

bool InsteadOfHands::pointer(const view::InputEvent& e, const view::Camera& camera) {
  return paddle_ ? paddle_->pointer(e) : coil_.hand().pointer(e, camera, desk_.world.wheel->clay);
}

void InsteadOfHands::move_by_keys(double side, double outward, double up) {
  const ClayView& clay = desk_.world.wheel->clay;
  paddle_ ? paddle_->move_by_keys(side, up, clay) : coil_.hand().move_by_keys(side, outward, clay);
}

void InsteadOfHands::follow(double dt) {
  paddle_ ? paddle_->follow(dt) : coil_.hand().follow(desk_.world.wheel->clay, dt);
}

void InsteadOfHands::send(const view::Camera& camera) const {
  if (!paddle_) return coil_.send(camera);
  desk_.world.wheel_commands->hand(0, paddle_->input(camera, desk_.world.wheel->clay));
  desk_.world.wheel_commands->hand(1, {});
}

void InsteadOfHands::work_by_itself(const Profile& target, double side) {
  paddle_ ? paddle_->beat_up(side, kOnceUp) : coil_.lay_a_ring(target, side);
}

Button InsteadOfHands::button(Button show) const {
  if (!paddle_) return coil_.button(show);
  if (by_itself()) show.look = Look::chosen;
  return show;
}

}  // namespace onggi::screens
