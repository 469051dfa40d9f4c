#include "kiosk/visit/screens/turntable.h"

#include <algorithm>
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

bool Turntable::pair(const view::InputEvent& event, float half_turn) {
  using Kind = view::InputEvent::Kind;
  if (event.finger >= fingers_.size()) return paired_;
  auto& finger = fingers_[event.finger];
  const auto down = [&] {
    return std::ranges::count_if(fingers_, [](const auto& one) { return one.has_value(); });
  };
  if (event.kind == Kind::pointer_down) {
    finger = {event.x, event.y};
    if (down() > 1) paired_ = true, dragged_.reset();
    return paired_;
  }
  if (event.kind != Kind::pointer_move && event.kind != Kind::pointer_up) return false;
  if (finger && paired_) {
    // The middle between them turns it: each finger carries its part.
    const auto part = static_cast<double>(down()) * static_cast<double>(half_turn);
    turn(-0.5 * kOnce * static_cast<double>(event.x - finger->first) / part);
    tilt_ = std::clamp(tilt_ + 0.25 * kOnce * static_cast<double>(event.y - finger->second) / part,
                       kLeastTilt, kMostTilt);
  }
  if (finger) finger = {event.x, event.y};
  const bool theirs = paired_;
  if (event.kind == Kind::pointer_up) finger.reset();
  if (down() == 0) paired_ = false;
  return theirs;
}

void Turntable::let_go() {
  fingers_ = {};
  paired_ = false;
  dragged_.reset();
}

void Turntable::by_arrow(bool to_the_right) { turn(to_the_right ? -kAnArrow : kAnArrow); }

void Turntable::press(double speed, double now) {
  turn(speed < 0 ? -kAPress : kAPress);
  rests_until_ = now + kRest;
}

}  // namespace onggi::screens
