#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Is a hand at a handle that has no sensor for one? Somebody is who moves it; nobody has been for
/// a while once it stays where it is. One thread.
class Presence {
 public:
  static constexpr double kTaken = 0.004;   ///< m: no handle at rest wanders so far,
  static constexpr double kStill = 0.0005;  ///< m: nor does a hand stay within that
  static constexpr double kLeft = 20.0;     ///< s: for so long.

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
