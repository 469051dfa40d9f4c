#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/box.h"
#include "engine/contact/bodies/capsule.h"
#include "engine/contact/bodies/cylinder.h"
#include "engine/math/vec.h"

namespace onggi {

/// How the clay gives way and pushes back.
struct Yielding {
  double relaxation_time = 0;  ///< tau, s, > 0.
  double stiffness = 0;        ///< k_A, N per metre of press and m^2 of wall.
  /// Share of the pressed face's lost area that also moves the other face, 0..1: 1 moves the wall,
  /// 0 thins it. Only if the clay keeps its rows' areas (Clay::keep_areas).
  double along = 0;
  bool cut = false;  ///< Pressed clay is removed, not displaced. Only with keep_areas, too.
};

/// The result of one step of pressing.
struct Press {
  Vec3 force;         ///< On the tool, clay frame, mean over the step, N.
  double normal = 0;  ///< Sum of the elements' normal forces, N; friction is computed from it.
  double depth = 0;   ///< Deepest press, m.
  std::int64_t visited = 0;  ///< Elements looked at.
  std::int64_t touched = 0;  ///< Elements pressed.
};

namespace body {

/// Presses a Ball, Capsule, Box or Cylinder on the `side` face for one step of `seconds` (> 0) and
/// lets the clay yield: Lee, Han & Choi 2008, eqs. 3-9, corrected (engine/docs/contact.md). `body`
/// is at its place in the middle of the step, and moves at most about a quarter of its finest part
/// per step. `at` is a point in the body. Marks dirty rows. No allocation. Same bits on every
/// machine.
template <class Body>
Press press(Clay& clay, WallSide side, const Body& body, Vec3 at, double seconds,
            const Yielding& yielding) noexcept;

/// Depth by which the body at rest would press the `side` face at its deepest element, metres; 0
/// when clear. Changes nothing. Adds the elements looked at to `visited`.
template <class Body>
double depth(const Clay& clay, WallSide side, const Body& body, Vec3 at,
             std::int64_t& visited) noexcept;

}  // namespace body
}  // namespace onggi
