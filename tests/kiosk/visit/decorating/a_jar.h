#pragma once

#include <cmath>

#include "engine/profile/profile.h"

namespace onggi::decorating {

/// A jar of 160 mm with a belly, and a wall of 6 mm on a floor.
inline Profile a_jar() {
  Profile profile;
  for (int n = 0; n <= 40; ++n) {
    const double outer = 0.05 + 0.02 * std::sin(3.0 * n / 40.0);
    profile.points.push_back({0.16 * n / 40, outer, n < 2 ? 0.0 : outer - 0.006});
  }
  return profile;
}

}  // namespace onggi::decorating
