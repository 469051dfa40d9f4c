#include "tests/stand_in/track.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace onggi::stand_in {

Track Track::read(const std::string& file, long start) {
  std::ifstream in(file);
  std::vector<TrackPoint> points;
  TrackPoint point;
  int active = 0;
  while (in >> point.at.x >> point.at.y >> point.at.z >> active) {
    point.active = active != 0;
    points.push_back(point);
  }
  if (points.empty() || !in.eof()) throw std::runtime_error(file + ": no track of x y z active");
  return Track(std::move(points), start);
}

TrackPoint Track::at(long ms) const {
  if (points_.empty()) return {};
  const long last = static_cast<long>(points_.size()) - 1;
  TrackPoint point = points_[static_cast<std::size_t>(std::clamp(ms - start_, 0L, last))];
  if (ms < start_ || ms > start_ + last) point.active = false;
  return point;
}

long Track::next_down(long ms) const {
  for (long n = std::max(0L, ms - start_); n < static_cast<long>(points_.size()); ++n)
    if (points_[static_cast<std::size_t>(n)].active) return start_ + n;
  return -1;
}

}  // namespace onggi::stand_in
