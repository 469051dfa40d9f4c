#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/contact/wall_side.h"
#include "engine/math/vec.h"

namespace onggi {

/// A sphere's way through the clay in one step. All in the clay's turning frame, so the wheel's
/// turn is in the way from `from` to `to`. Metres, seconds.
struct SphereStep {
  Vec3 from;           ///< Centre as the step begins.
  Vec3 to;             ///< Centre as it ends; at most about radius / 4 away.
  double radius = 0;   ///< > 0.
  double seconds = 0;  ///< > 0.
};

/// How the clay gives way and pushes back.
struct Yielding {
  double relaxation_time = 0;  ///< tau, s, > 0.
  double stiffness = 0;        ///< k_A, N per metre of press and m^2 of wall.
};

/// What one step of pressing came to.
struct Press {
  Vec3 force;                ///< On the tool, clay frame, mean over the step, N.
  double normal = 0;         ///< Sum of the elements' normal forces, N; friction is made of it.
  double depth = 0;          ///< Deepest press, m.
  std::int64_t visited = 0;  ///< Elements looked at.
  std::int64_t touched = 0;  ///< Elements pressed.
};

/// Presses the sphere on the `side` face for one step and lets the clay give way: Lee, Han & Choi
/// 2008, eqs. 3-9, corrected (engine/docs/contact.md). Marks dirty rows. No allocation. Equal bits
/// on every machine.
Press press(Clay& clay, WallSide side, const SphereStep& step, const Yielding& yielding) noexcept;

/// How deep a sphere at rest at `at` (clay frame) would press the `side` face: the deepest element,
/// metres, 0 when clear. Changes nothing. `visited`, if given, grows by the elements looked at.
double depth_at(const Clay& clay, WallSide side, Vec3 at, double radius,
                std::int64_t* visited = nullptr) noexcept;

}  // namespace onggi
