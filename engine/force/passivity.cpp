#include "engine/force/passivity.h"

#include <algorithm>

namespace onggi::force {

Vec3 PassivityControl::step(Vec3 hand, Vec3 force, const Touch& touch, double seconds,
                            const PassivityLimits& limits) noexcept {
  const Vec3 velocity = velocity_.go(hand, seconds);
  if (known_) {
    const auto late = static_cast<std::size_t>(std::clamp(limits.delay, 0, kMostDelay));
    const Given& held = given_[(newest_ + given_.size() - late) % given_.size()];
    const Vec3 way = hand - hand_;
    energy_ += -dot(held.force, way) + seconds * dot(held.force, held.clay) +
               limits.own_damping * dot(way, way) / seconds;
  }
  known_ = true;
  hand_ = hand;
  const double softness =
      1.0 / limits.stiffness + (touch.stiffness > 0.0 ? 1.0 / touch.stiffness : 0.0);
  energy_ = std::clamp(energy_, -kMostDebt, 0.5 * dot(force, force) * softness);

  damping_ = 0.0;
  const double square = dot(velocity, velocity);
  if (energy_ < 0.0 && square > 0.0)
    damping_ = std::min(-energy_ / (seconds * square), limits.most_damping);
  const Vec3 out = force - damping_ * velocity;
  newest_ = (newest_ + 1) % given_.size();
  given_[newest_] = {out, touch.clay};
  return out;
}

}  // namespace onggi::force
