#pragma once

#include <cstdint>

#include "engine/clay/block_run.h"
#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"

namespace onggi::contact {

/// What goes between press.cpp, which knows the clay, and the kernels, which know only floats.
/// Plain data: kernels are compiled for processors that the rest is not compiled for (lanes.h).

/// Rows are planned and pressed so many at a time.
inline constexpr int kPlannedRows = 32;

/// What holds for all elements of a step.
struct StepFigures {
  const float* ray_cos = nullptr;
  const float* ray_sin = nullptr;
  float limit = 0;     ///< How far the face may be pressed, m: the clay keeps radius_min, wall_min
                       ///< and radius_max.
  float wall_min = 0;  ///< m
  float gone = 0;      ///< 1 - e^(-dt/tau): how much of a press the clay gives way by in the step.
  float mean = 0;      ///< (tau/dt) (1 - e^(-dt/tau)): of a press, its mean over the step.
  float along = 0;     ///< Yielding::along
  float farthest = 0;  ///< That the other face may go, m: radius_min outside, radius_max inside.
  bool keeps;          ///< What rows lose is summed, and the other face may go along.
};

/// Where rows lie that are planned together, and what is known of each: row k is the k-th of them.
struct RowPlaces {
  float* face;                ///< Of stored row 0: worked.
  float* behind;              ///< The other.
  int stride;                 ///< Floats from one stored row to the next.
  int sectors;                ///< Of them; the rest is padding.
  const int* stored;          ///< By row: as which it is stored.
  const float* behind_start;  ///< By row: no element of the other face is farther that way.
  const double* thickness;    ///< By row, m.
  double weight;              ///< Force per press, radius and thickness.
  int hollow_from;            ///< Rows from here on have another face.
  std::uint32_t careful;      ///< Bit k: row k is pressed with care (press_lanes.h).
};

/// One row that a body presses, and what came of it. Filled whole by whoever asks: nothing is set
/// beforehand, since a step has many.
struct RowTask {
  int k;                ///< In RowPlaces.
  int used;             ///< Of `ranges`.
  BlockRun ranges[2];   ///< They never share a block.
  float* displacement;  ///< Grows by what each element was moved; only where StepFigures::keeps.

  float behind_most;  ///< The farthest that the other face was carried; where RowsPressed::carried.
  float lost;         ///< Sum of squares of radii; where StepFigures::keeps.
};

/// What came of all rows of a call.
struct RowsPressed {
  int blocks = 0;             ///< Looked at, of eight elements.
  int touched = 0;            ///< Elements pressed.
  std::uint32_t changed = 0;  ///< Bit k: of row k.
  std::uint32_t carried = 0;  ///< Bit k: and its other face was carried beyond behind_start.
};

/// A row, and the section that a Body of faces and rods has with it.
template <class Body>
struct BodyRow : RowTask {
  typename Body::Section section;
  const body::Outline* outline;
  float sector;  ///< Angle of an element, rad.
  float share;   ///< Of the row's height that is covered.
};

/// The sections of kPlannedRows rows with a ball, circles, and which elements they can touch: an
/// array each, since they are worked out eight at a time. Metres.
struct BallWindows {
  float above[kPlannedRows];         ///< Given: middle of the ball above the row.
  float extent[kPlannedRows];        ///< Given: of the face, Clay::outer_most() or inner_least().
  float section[kPlannedRows];       ///< Radius of the circle.
  float edge[kPlannedRows];          ///< Farthest from its middle that the ray of an element
                                     ///< covered in part may pass.
  float per_width[kPlannedRows];     ///< 1 / m: of an element at the circle's tangents.
  float most_covered[kPlannedRows];  ///< Share of an element that the circle can cover, 0..1.
  float above_radii[kPlannedRows];   ///< Middle of the ball above the row, over its radius.
  int low[kPlannedRows], high[kPlannedRows];  ///< Elements between which it touches, two turns on.
  std::uint32_t reached;                      ///< Bit k: row k has something that can be touched.
  std::uint32_t careful;  ///< Bit k: the row is to be pressed with care (press_lanes.h).
};

template <>
struct BodyRow<body::Ball> : RowTask {};

/// What all rows of a body have in common.
template <class Body>
struct BodyFigures {};
template <>
struct BodyFigures<body::Ball> {
  float x, z;               ///< Its middle, m.
  float per_radius;         ///< 1 / m
  float x_radii, z_radii;   ///< Its middle from the axis, over its radius.
  const BallWindows* rows;  ///< By RowTask::k.
};

/// A kernel's sums between two of its calls in one step: eight accumulators of each. Until they
/// have begun they are nothing, and are not set: most steps have one call and never need them.
struct PressSums {
  bool begun = false;
  float weight[8], x[8], y[8], z[8];  ///< Of rows equally thick.
  float force_x[8], force_y[8], force_z[8], normal[8];
  float depth[8];
  double thickness;  ///< Of the rows in `weight` to `z`, m.
};
struct PressTotal {
  float x = 0, y = 0, z = 0;  ///< Force on the tool, N.
  float normal = 0;           ///< N
  float depth = 0;            ///< Deepest press, m.
};

}  // namespace onggi::contact
