#pragma once

#include "engine/math/vec.h"

namespace onggi::force {

/// The contact of one tool in a tick, before any guard: what a device's coupling needs from the
/// clay. Studio frame.
struct Touch {
  Vec3 push;                ///< Of clay, floor and wheel head on the tool, without friction, N.
  double stiffness = 0.0;   ///< N/m, >= 0: upper bound of how much harder they push a metre deeper.
  double relaxation = 0.0;  ///< s in which the push falls to 1/e if nothing moves; 0: it stays.
  double grip = 0.0;        ///< N, >= 0: most that friction (or a wire's cut) holds.
  Vec3 clay;                ///< Velocity of the clay where it touches, m/s.
};

}  // namespace onggi::force
