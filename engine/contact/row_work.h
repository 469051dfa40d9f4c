#pragma once

#include <cstdint>

#include "engine/clay/block_run.h"
#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"

namespace onggi::contact {

/// Data passed between press.cpp, which knows the clay, and the kernels, which know only floats.
/// Plain data, because kernels are compiled for other processors than the rest (lanes.h).

/// Rows planned and pressed together.
inline constexpr int kPlannedRows = 32;

/// Ends of a body that is sunk deeper than its radius face the ray by less, and are felt as if they
/// faced it so far: n . ray.
inline constexpr float kLeastFacing = 0.25f;

/// Figures for all elements of a step.
struct StepFigures {
  const float* ray_cos = nullptr;
  const float* ray_sin = nullptr;
  /// Limit of the pressed face, m: the clay keeps radius_min, wall_min and radius_max.
  float limit = 0;
  float wall_min = 0;  ///< m
  float gone = 0;      ///< 1 - e^(-dt/tau): share of a press by which the clay yields in the step.
  float mean = 0;      ///< (tau/dt) (1 - e^(-dt/tau)): mean of a press over the step, as a share.
  float along = 0;     ///< Yielding::along
  float farthest = 0;  ///< Limit of the other face, m: radius_min outside, radius_max inside.
  bool keeps;          ///< Sum what rows lose; the other face may follow.
};

/// Where the rows planned together are stored, and facts about each. Row k is the k-th of them.
struct RowPlaces {
  float* face;                ///< Worked face of stored row 0.
  float* behind;              ///< The other face.
  int stride;                 ///< Floats between stored rows.
  int sectors;                ///< In a row; the rest is padding.
  const int* stored;          ///< By row: index of its stored row.
  const float* behind_start;  ///< By row: no element of the other face lies farther that way.
  const double* thickness;    ///< By row, m.
  double weight;              ///< Force per press, radius and thickness.
  int hollow_from;            ///< Rows from here on have a second face.
  std::uint32_t careful;      ///< Bit k: press row k with care (press_lanes.h).
};

/// One row to press, and the result. The caller fills all of it: there are no defaults, because a
/// step has many rows.
struct RowTask {
  int k;                ///< Index in RowPlaces.
  int used;             ///< How many of `ranges`.
  BlockRun ranges[2];   ///< They never share a block.
  float* displacement;  ///< Adds each element's displacement; only if StepFigures::keeps.

  float behind_most;  ///< Farthest that the other face was moved; set only if in
                      ///< RowsPressed::carried.
  float lost;         ///< Sum of squares of radii; set only if StepFigures::keeps.
};

/// The results of all rows of a call.
struct RowsPressed {
  int blocks = 0;             ///< Blocks of eight elements looked at.
  int touched = 0;            ///< Elements pressed.
  std::uint32_t changed = 0;  ///< Bit k: row k changed.
  std::uint32_t carried = 0;  ///< Bit k: row k's other face moved beyond behind_start.
};

/// A row, and its section with a Body of faces and rods.
template <class Body>
struct BodyRow : RowTask {
  typename Body::Section section;
  const body::Outline* outline;
  float sector;  ///< Angle of an element, rad.
  float share;   ///< Share of the row's height that is covered.
};

/// Circles in which kPlannedRows rows cut a ball, and the elements that they can touch. One array
/// each, because they are computed eight at a time. Metres.
struct BallWindows {
  float above[kPlannedRows];    ///< Input: height of the ball's middle above the row.
  float extent[kPlannedRows];   ///< Input: the face's Clay::outer_most() or inner_least().
  float section[kPlannedRows];  ///< Radius of the circle.
  float edge[kPlannedRows];  ///< Farthest from the circle's middle that the ray of a partly covered
                             ///< element may pass.
  float per_width[kPlannedRows];     ///< 1 / (element width at the circle's tangents), 1/m.
  float most_covered[kPlannedRows];  ///< Share of an element that the circle can cover, 0..1.
  float above_radii[kPlannedRows];   ///< Height of the ball's middle above the row, over the ball's
                                     ///< radius.
  int low[kPlannedRows],
      high[kPlannedRows];  ///< First and last element that it touches, plus two turns.
  std::uint32_t reached;   ///< Bit k: row k has elements to touch.
  std::uint32_t careful;   ///< Bit k: press the row with care (press_lanes.h).
};

template <>
struct BodyRow<body::Ball> : RowTask {};

/// Figures that all rows of a body share.
template <class Body>
struct BodyFigures {};
template <>
struct BodyFigures<body::Ball> {
  float x, z;               ///< Its middle, m.
  float per_radius;         ///< 1 / m
  float x_radii, z_radii;   ///< Its middle, from the axis, over its radius.
  float squareness;         ///< 1 / (1 + slope^2) of the worked face beside it.
  float slant;              ///< squareness slope radius, m; negative from inside.
  float least_chord;        ///< Half of a chord counts as this long at least, m.
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
