#include "kiosk/visit/screens/moved_light.h"

#include <algorithm>

namespace onggi::screens {

void MovedLight::keep_within(double low, double high) {
  low_ = low, high_ = high;
  if (at_) move(*at_);
}

void MovedLight::move(double to) { at_ = std::clamp(to, low_, high_); }

void MovedLight::pointer(const view::InputEvent& event, double from, float across) {
  using Kind = view::InputEvent::Kind;
  if (event.kind == Kind::pointer_down) dragged_ = event.x;
  if (!dragged_) return;
  if (event.x != *dragged_)
    move(at(from) + 2.0 * kFarthest * static_cast<double>((event.x - *dragged_) / across));
  dragged_ = event.x;
  if (event.kind == Kind::pointer_up) dragged_.reset();
}

void MovedLight::by_arrow(double from, bool to_the_right) {
  move(at(from) + (to_the_right ? kAnArrow : -kAnArrow));
}

void MovedLight::press(double from) { move(at(from) >= high_ ? low_ : at(from) + kAPress); }

}  // namespace onggi::screens
