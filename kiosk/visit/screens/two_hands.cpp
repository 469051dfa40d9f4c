#include "kiosk/visit/screens/two_hands.h"

namespace onggi::screens {

using device::Grip;
using view::InputEvent;

void TwoHands::pointer(const InputEvent& event, Vec2 at, const ClayView& clay) {
  if (event.kind == InputEvent::Kind::pointer_down) {
    const std::size_t which = at.x < 0 ? kInside : kOutside;
    if (fingers_[which]) return;  // a visitor already has that hand
    fingers_[which] = event.finger;
    hands_[which].lift();
    hands_[which].grab(at, clay, which == kInside ? Grip::inside : Grip::outside);
    return;
  }
  for (std::size_t which = 0; which < hands_.size(); ++which) {
    if (fingers_[which] != event.finger) continue;
    if (event.kind == InputEvent::Kind::pointer_move) hands_[which].drag(at);
    if (event.kind == InputEvent::Kind::pointer_up) {
      hands_[which].release();
      fingers_[which].reset();
    }
  }
}

void TwoHands::move_by_keys(const ClayView& clay, double outward, double up) {
  if (fingers_[kInside]) return;
  device::PointerLead& hand = hands_[kInside];
  if (hand.active())
    hand.move(outward, up);
  else
    hand.begin_by_keys(clay, Grip::inside, -1);
}

void TwoHands::follow(const ClayView& clay, double dt, const std::array<bool, kMaxHands>& contact) {
  for (std::size_t which = 0; which < hands_.size(); ++which)
    if (hands_[which].active()) hands_[which].follow(clay, dt, contact[which]);
}

void TwoHands::lift() {
  for (device::PointerLead& hand : hands_) hand.lift();
  for (auto& finger : fingers_) finger.reset();
}

std::array<HandInput, kMaxHands> TwoHands::input(Vec3 right) const {
  auto both = hands_[kOutside].input(right);
  // If only the inside works, hand 0 does it.
  both[1] = hands_[kInside].input(right)[0];
  if (!hands_[kInside].active()) both[1].active = false;
  return both;
}

}  // namespace onggi::screens
