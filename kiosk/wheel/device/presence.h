#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Guesses whether a hand holds a handle without a sensor: yes if the handle moves, no after it has
/// been still for a while. One thread.
class Presence {
 public:
  static constexpr double kTaken = 0.004;   ///< m: a handle at rest never drifts this far,
  static constexpr double kStill = 0.0005;  ///< m: and a hand never stays within this
  static constexpr double kLeft = 20.0;     ///< s: for this long.

  void look(Vec3 place, std::int64_t now_ns) noexcept {
    if (!known_ || length(place - around_) > (held_ ? kStill : kTaken)) {
      held_ = held_ || known_;
      known_ = true;
      around_ = place;
      moved_ns_ = now_ns;
    } else if (now_ns - moved_ns_ > static_cast<std::int64_t>(kLeft * 1e9)) {
      held_ = false;
    }
  }
  bool held() const noexcept { return held_; }

 private:
  Vec3 around_;
  std::int64_t moved_ns_ = 0;
  bool known_ = false, held_ = false;
};

}  // namespace onggi::device
