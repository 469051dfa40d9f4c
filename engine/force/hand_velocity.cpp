#include "engine/force/hand_velocity.h"

#include <algorithm>
#include <cmath>

namespace onggi::force {

Vec3 HandVelocity::go(Vec3 to, double seconds) noexcept {
  if (known_ == 0) {
    time_ = 0.0;
    anchor_ = to;
    newest_ = 0;
    known_ = 1;
    kept_[0] = {time_, anchor_};
    return {};
  }
  time_ += seconds;
  const Vec3 leash = to - anchor_;
  const double taut = std::sqrt(dot(leash, leash));
  if (taut > kTremble) anchor_ += (1.0 - kTremble / taut) * leash;

  Vec3 velocity;
  for (std::size_t n = 0; n < known_; ++n) {
    const Sample& back = kept_[(newest_ + kRoom - n) % kRoom];
    const double ago = time_ - back.time;
    // A window full of ticks is as long as it should be, whatever rounding says.
    if (n > 0 && ago > kWindow * (1.0 + 1e-9)) break;
    const Vec3 way = anchor_ - back.at;
    velocity = (1.0 / ago) * way;
    if (dot(way, way) >= kEnough * kEnough) break;
  }
  if (time_ - kept_[newest_].time < kApart * (1.0 - 1e-9)) return velocity;
  newest_ = (newest_ + 1) % kRoom;
  known_ = std::min(known_ + 1, kRoom);
  kept_[newest_] = {time_, anchor_};
  return velocity;
}

void HandVelocity::add_to(StateHash& hash) const {
  if (known_ == 0) return;
  for (const double v : {time_, anchor_.x, anchor_.y, anchor_.z}) hash.add(v);
  for (std::size_t n = 0; n < known_; ++n) {
    const Sample& back = kept_[(newest_ + kRoom - n) % kRoom];
    for (const double v : {back.time, back.at.x, back.at.y, back.at.z}) hash.add(v);
  }
}

}  // namespace onggi::force
