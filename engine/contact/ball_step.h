#pragma once

#include "engine/math/vec.h"

namespace onggi {

/// One step of the sphere that represents a tool pressing from above, on the rim or the floor. For
/// a tool of another shape it is the lowest sphere inside the tool. Clay's turning frame. Metres,
/// seconds.
struct BallStep {
  Vec3 from;           ///< Centre at the start.
  Vec3 to;             ///< Centre at the end; moves at most about radius / 4.
  double radius = 0;   ///< > 0.
  double seconds = 0;  ///< > 0.
};

}  // namespace onggi
