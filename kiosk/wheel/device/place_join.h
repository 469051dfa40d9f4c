#pragma once

#include <cstdint>

#include "engine/math/vec.h"

namespace onggi::device {

/// Joins the places of a handle that speaks less often than the wheel ticks (60 to 125 a second)
/// into one smooth way: it goes on as it went between the last two reports, for as long as the next
/// may take, and what that was wrong by is made good with `smoothing` as its time constant
/// (implicit Euler). An even way is joined without any lag. No allocation; one thread.
class PlaceJoin {
 public:
  static constexpr double kLongest = 0.05;  ///< s: reports that are farther apart are not joined.

  /// Where it is at `now_ns`, `dt` seconds after the last call. `reports` counts them; the newest
  /// said `place` (m) at `at_ns`. `smoothing` s, > 0.
  Vec3 at(Vec3 place, std::uint64_t reports, std::int64_t at_ns, std::int64_t now_ns, double dt,
          double smoothing) noexcept;
  void release() noexcept { *this = PlaceJoin(); }

 private:
  std::uint64_t reports_ = 0;  ///< 0: none yet.
  Vec3 last_, speed_, out_;
  std::int64_t last_ns_ = 0;
  double apart_ = 0.0;  ///< s between the last two.
};

}  // namespace onggi::device
