#pragma once

#include "engine/math/vec.h"

namespace onggi::force {

/// What a hand at a force device feels of a blow that it strikes: a short push back, as long and as
/// strong as such a device can render it (a real one is 300 to 1,200 N for a thousandth of a
/// second). Passive: the push ends as soon as it has given the hand as much work as it took, so a
/// hand that is thrown back gains at most what it moves within one tick, and within the guard's
/// time to fade. No allocation; one thread.
class BlowPulse {
 public:
  static constexpr double kSeconds = 0.024;  ///< How long it lasts.
  static constexpr double kMost = 4.5;       ///< N: the strongest push.
  static constexpr double kHalf = 40.0;      ///< N of a blow that is felt at half of kMost.

  /// A blow of `force` (N, Struck::force) pushes the hand `out` (unit, studio frame). A later blow
  /// replaces it.
  void begin(double force, Vec3 out) noexcept;
  /// The hand has moved by `way` (m) since the last call. Returns the push for the tick of
  /// `seconds` that follows, N.
  Vec3 step(Vec3 way, double seconds) noexcept;
  void release() noexcept { *this = {}; }
  bool any() const { return peak_ > 0.0; }

 private:
  double peak_ = 0.0;   // N; 0: none
  double since_ = 0.0;  // s
  double taken_ = 0.0;  // J that the push took from the hand
  Vec3 last_;           // N: the push of the tick that has passed
  Vec3 out_;
};

}  // namespace onggi::force
