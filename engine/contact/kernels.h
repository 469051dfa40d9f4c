#pragma once

#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/box.h"
#include "engine/contact/bodies/capsule.h"
#include "engine/contact/bodies/cylinder.h"
#include "engine/contact/row_work.h"
#include "engine/math/vectors.h"

namespace onggi::contact {

/// How one body presses rows, compiled for one kind of vectors. No allocation, any thread.
template <class Body>
struct BodyKernel {
  /// Presses `count` rows on the `side` face, one after the other, and adds to `sums`. For the
  /// step's last rows, writes the step's total to `total` instead.
  RowsPressed (*press)(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                       const RowPlaces& places, BodyRow<Body>* rows, int count, PressSums& sums,
                       PressTotal* total);
  /// Depth of the deepest element of `rows` under the body, m; 0 when clear. Changes nothing.
  float (*depth)(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                 const RowPlaces& places, const BodyRow<Body>* rows, int count);
};

/// Figures for finding ball windows, the same for all rows.
struct WindowFigures {
  float radius, distance;     ///< The ball's radius, and its middle's distance from the axis, m.
  float per_radius;           ///< 1 / m
  float per_radian, radians;  ///< Elements per radian, and radians per element.
  float middle;               ///< The ball's angle in elements, plus `turns`: always positive.
  float limit;                ///< A row needs care if the ball asks for more than this, m.
};

/// Everything that is compiled for each kind of vectors.
struct Kernels {
  const BodyKernel<body::Ball>* ball;
  const BodyKernel<body::Capsule>* capsule;
  const BodyKernel<body::Box>* box;
  const BodyKernel<body::Cylinder>* cylinder;
  /// Fills all of `rows` except its given figures.
  void (*windows)(WallSide side, const WindowFigures& figures, int count, BallWindows& rows);
  /// Half the angle that eight sections reach in rows of `extent`: radius `r`, distance `d` from
  /// the axis, tangents `t`. Negative if nothing is reached.
  void (*half_windows)(WallSide side, const float* d, const float* r, const float* t,
                       const float* extent, float* half);
  /// Largest outer, or smallest inner, radius of a row's `side` face, m.
  float (*extent)(WallSide side, int stride, const float* face);
};

/// The kernels for one kind of vectors, which vectors_here() must contain.
const Kernels& kernels(Vectors kind) noexcept;

}  // namespace onggi::contact
