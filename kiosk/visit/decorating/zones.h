#pragma once

#include <vector>

#include "engine/surface/surface.h"

namespace onggi::decorating {

/// The zones of a pot as decorators see them: foot, belly, shoulder, neck.
class Zones {
 public:
  /// Parts of the outside where the outline turns by 17 degrees or more within 10 mm, and by the
  /// most nearby, part its zones. `outside`: the outside's length, m. None for a smooth jar.
  Zones(const surface::Surface& surface, double outside);

  /// What part the zones, m from the foot along the outline, rising.
  const std::vector<double>& borders() const { return borders_; }

  static constexpr double kMost = 0.004;  ///< m
  /// `at`, moved by no more than kMost so that something which reaches `below` and `above` it, m,
  /// lies in one zone; `at` where that is too far, or where no zone has room.
  double within(double at, double below, double above) const;

 private:
  double end_;
  std::vector<double> borders_;
};

}  // namespace onggi::decorating
