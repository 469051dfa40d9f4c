#include "kiosk/device/pointer_hand.h"

#include <algorithm>

namespace onggi::device {

void PointerHand::aim(const HandInput& target) noexcept { target_ = target; }

HandInput PointerHand::read(double dt) noexcept {
  const bool set_down = target_.active && !hand_.active;
  hand_.active = target_.active;
  hand_.side = target_.side;
  if (set_down || !hand_.active) {
    hand_.position = target_.position;
    return hand_;
  }
  // Implicit Euler of x' = (target - x) / settle_time: no overshoot at any dt, and no exp, so the
  // same bits on every machine. First order is enough: the pointer itself is only good to a pixel.
  const Vec3 gap = target_.position - hand_.position;
  Vec3 move = gap * (dt / (def_.settle_time + dt));
  const double distance = length(move);
  const double limit = def_.max_speed * dt;
  if (distance > limit) move = move * (limit / distance);
  hand_.position += move;
  return hand_;
}

}  // namespace onggi::device
