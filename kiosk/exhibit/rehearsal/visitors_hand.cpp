#include "kiosk/exhibit/rehearsal/visitors_hand.h"

namespace onggi::rehearsal {

bool VisitorsHand::step(double dt, loop::WheelHost& wheel_host) {
  Hands hands;
  const auto look = [&](double t) {
    return wheel_host.with_scene([&](Scene& scene) { hands = script_->at(t, scene.clay()); });
  };
  // The script pauses just before the tool goes down again.
  const double next = time_ + dt;
  if (!look(next)) return false;
  bool active = false;
  for (const HandInput& hand : hands.hand) active = active || hand.active;
  carried_ = active && down_ ? 0.0 : carried_ + dt;
  const bool waits = active && !down_ && carried_ < kCarry;
  if (waits) {
    for (HandInput& hand : hands.hand) hand.active = false;
  } else {
    time_ = next;
    down_ = active;
  }
  wheel_host.wheel(hands.wheel_speed);
  wheel_host.water(hands.water);
  if (by_ == By::pointer)
    for (int n = 0; n < kMaxHands; ++n) wheel_host.hand(n, hands.hand[static_cast<std::size_t>(n)]);
  return true;
}

}  // namespace onggi::rehearsal
