#include "kiosk/visit/screens/wheel_hands.h"

#include <algorithm>

namespace onggi::screens {

using device::Grip;
using view::InputEvent;

bool WheelHands::pointer(const InputEvent& e, Vec2 at, const ClayView& clay, Grip grip, bool tool) {
  if (two_) {
    two_->pointer(e, at, clay);
    return true;
  }
  if (e.finger != 0) {
    // Two fingers hold the wall between them; further ones are ignored.
    if (e.finger == 1 && !tool && grip == Grip::both)
      lead_.pinch(e.kind == InputEvent::Kind::pointer_up ? std::nullopt : std::optional(at), clay);
    return false;
  }
  switch (e.kind) {
    case InputEvent::Kind::pointer_down:
      lead_.grab(at, clay, grip);
      return true;
    case InputEvent::Kind::pointer_move:
      if (!lead_.grabbed()) return false;
      lead_.drag(at);
      return true;
    case InputEvent::Kind::pointer_up:
      if (!lead_.grabbed()) return false;
      lead_.release();
      return true;
    case InputEvent::Kind::scroll:
      if (!lead_.active()) return false;
      lead_.move(-kNotch * static_cast<double>(e.scroll), 0);
      return true;
    default:
      return false;
  }
}

void WheelHands::move_by_keys(const ClayView& clay, Grip grip, double sign, double outward,
                              double up) {
  if (two_) return two_->move_by_keys(clay, outward, up);
  if (lead_.active())
    lead_.move(outward, up);
  else
    lead_.begin_by_keys(clay, grip, sign);
}

void WheelHands::follow(const ClayView& clay, double dt,
                        const std::array<bool, kMaxHands>& contact) {
  if (two_) two_->follow(clay, dt, contact);
  lead_.follow(clay, dt, std::find(contact.begin(), contact.end(), true) != contact.end());
}

void WheelHands::take_up(device::WallHold::Part broad, device::WallHold::Part fine) {
  lead_.take_up(broad, fine);
  if (two_) two_->take_up(broad, fine);
}

void WheelHands::lift() {
  lead_.lift();
  if (two_) two_->lift();
}

void WheelHands::send(const Desk& desk, const view::Camera& camera) const {
  Vec3 right, up, back;
  camera.basis(right, up, back);
  const auto hands = two_ && !lead_.active() ? two_->input(right) : lead_.input(right);
  for (int n = 0; n < kMaxHands; ++n)
    desk.world.wheel_commands->hand(n, hands[static_cast<std::size_t>(n)]);
}

}  // namespace onggi::screens
