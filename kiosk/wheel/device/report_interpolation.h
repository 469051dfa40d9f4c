#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Interpolates the positions of a handle that reports less often (60 to 125 a second) than the
/// wheel ticks. It continues at the speed between the last two reports, for as long as the next one
/// may take, and corrects the error with the time constant `smoothing` (implicit Euler). An even
/// motion has no lag. No allocation; one thread.
class ReportInterpolation {
 public:
  static constexpr double kLongest = 0.05;  ///< s: reports farther apart are not joined.

  /// The position at `now_ns`, `dt` seconds after the last call. `reports` counts the reports; the
  /// newest gave `place` (m) at `at_ns`. `smoothing` s, > 0.
  Vec3 at(Vec3 place, std::uint64_t reports, std::int64_t at_ns, std::int64_t now_ns, double dt,
          double smoothing) noexcept;
  void release() noexcept { *this = ReportInterpolation(); }

 private:
  std::uint64_t reports_ = 0;  ///< 0: none yet.
  Vec3 last_, speed_, out_;
  std::int64_t last_ns_ = 0;
  double apart_ = 0.0;  ///< s between the last two.
};

}  // namespace onggi::device
