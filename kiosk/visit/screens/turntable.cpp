#include "kiosk/visit/screens/turntable.h"

#include <cmath>

namespace onggi::screens {

namespace {
constexpr double kOnce = 6.283185307179586;  // rad
}  // namespace

void Turntable::turn(double by) { angle_ = std::remainder(angle_ + by, kOnce); }

void Turntable::pointer(const view::InputEvent& event, float half_turn) {
  using Kind = view::InputEvent::Kind;
  if (event.kind == Kind::pointer_down) dragged_ = event.x;
  if (!dragged_) return;
  // Screen angles grow from the right towards the eye, so a finger moving right turns it back.
  turn(-0.5 * kOnce * static_cast<double>((event.x - *dragged_) / half_turn));
  dragged_ = event.x;
  if (event.kind == Kind::pointer_up) dragged_.reset();
}

void Turntable::by_arrow(bool to_the_right) { turn(to_the_right ? -kAnArrow : kAnArrow); }

void Turntable::press(double speed, double now) {
  turn(speed < 0 ? -kAPress : kAPress);
  rests_until_ = now + kRest;
}

}  // namespace onggi::screens
