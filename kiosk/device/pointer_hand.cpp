#include "kiosk/device/pointer_hand.h"

#include <utility>

namespace onggi::device {

HandInput PointerHand::read(double dt) noexcept {
  HandInput hand = target_;
  if (!std::exchange(down_, target_.active) || !target_.active) {
    at_ = target_.position;
    return hand;
  }
  // Implicit Euler of x' = (target - x) / settle_time: no overshoot at any dt, and no exp, so the
  // same bits on every machine. First order is enough: the pointer itself is only good to a pixel.
  const Vec3 gap = target_.position - at_;
  Vec3 move = gap * (dt / (def_.settle_time + dt));
  const double distance = length(move);
  const double limit = def_.max_speed * dt;
  if (distance > limit) move = move * (limit / distance);
  hand.position = at_ += move;
  return hand;
}

}  // namespace onggi::device
