#pragma once

#include "engine/math/vec.h"

namespace onggi {

/// One step of the sphere that stands for a tool where it presses from above: on the rim and on the
/// floor. A tool of another shape gives the lowest sphere within it. In the clay's
/// turning frame. Metres, seconds.
struct BallStep {
  Vec3 from;           ///< Centre as the step begins.
  Vec3 to;             ///< Centre as it ends; at most about radius / 4 away.
  double radius = 0;   ///< > 0.
  double seconds = 0;  ///< > 0.
};

}  // namespace onggi
