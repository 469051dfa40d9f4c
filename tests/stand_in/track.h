#pragma once

#include <string>
#include <vector>

#include "engine/math/vec.h"

namespace onggi::stand_in {

/// Where a visitor's tool is to be, a line a millisecond: what a simulated hand follows.
struct TrackPoint {
  Vec3 at;              ///< Studio frame, metres.
  bool active = false;  ///< Set down at the clay.
};

/// A file of lines `x y z active`, the first of them `start` milliseconds after the device was
/// plugged in.
class Track {
 public:
  Track() = default;
  explicit Track(std::vector<TrackPoint> points, long start = 0)
      : points_(std::move(points)), start_(start) {}
  /// Throws std::runtime_error where the file is not one.
  static Track read(const std::string& file, long start);

  /// At millisecond `ms` of the device's time; before and after it the hand is lifted.
  TrackPoint at(long ms) const;
  /// The next time from `ms` on at which the tool is down; -1 when there is none.
  long next_down(long ms) const;
  bool over(long ms) const { return ms >= start_ + static_cast<long>(points_.size()); }
  bool empty() const { return points_.empty(); }

 private:
  std::vector<TrackPoint> points_;
  long start_ = 0;
};

}  // namespace onggi::stand_in
