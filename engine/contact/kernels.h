#pragma once

#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/box.h"
#include "engine/contact/bodies/capsule.h"
#include "engine/contact/bodies/cylinder.h"
#include "engine/contact/row_work.h"
#include "engine/math/vectors.h"

namespace onggi::contact {

/// How one body presses rows, on one kind of vectors. No allocation, any thread.
template <class Body>
struct BodyKernel {
  /// Presses `count` rows one after the other, on the `side` face, and adds to `sums`; or, where
  /// they are the step's last, gives in `total` what all of them come to.
  RowsPressed (*press)(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                       const RowPlaces& places, BodyRow<Body>* rows, int count, PressSums& sums,
                       PressTotal* total);
  /// Depth of the deepest element of `rows` under the body, m; 0 when clear. Changes nothing.
  float (*depth)(WallSide side, const StepFigures& step, const BodyFigures<Body>& body,
                 const RowPlaces& places, const BodyRow<Body>* rows, int count);
};

/// What ball windows are found by, for all rows alike.
struct WindowFigures {
  float radius, distance;     ///< Of the ball; of its middle from the axis, m.
  float per_radius;           ///< 1 / m
  float per_radian, radians;  ///< Elements in a radian, and the other way.
  float middle;               ///< The ball's angle in elements, `turns` added: always positive.
  float limit;                ///< Rows where the ball asks for more than this (m) need care.
};

/// Everything that is compiled for each kind of vectors.
struct Kernels {
  const BodyKernel<body::Ball>* ball;
  const BodyKernel<body::Capsule>* capsule;
  const BodyKernel<body::Box>* box;
  const BodyKernel<body::Cylinder>* cylinder;
  /// Fills all of `rows` but what it is to be given.
  void (*windows)(WallSide side, const WindowFigures& figures, int count, BallWindows& rows);
  /// Half the angle of eight sections of radius `r`, `d` from the axis, tangents `t`, with rows of
  /// `extent`; negative where nothing is reached.
  void (*half_windows)(WallSide side, const float* d, const float* r, const float* t,
                       const float* extent, float* half);
  /// Largest outer, or smallest inner, radius of a row's `side` face, m.
  float (*extent)(WallSide side, int stride, const float* face);
};

/// The kernels of one kind of vectors, which vectors_here() must contain.
const Kernels& kernels(Vectors kind) noexcept;

}  // namespace onggi::contact
