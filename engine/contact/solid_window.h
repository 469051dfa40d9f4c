#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/row_work.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// The rows that a body of faces and rods reaches, and the angles. Clay frame, metres.
struct SolidWindow {
  /// `at` is a point of the body; `hull` contains the body.
  SolidWindow(const Clay& clay, const body::Heights& heights, const body::Hull& hull,
              const body::Approach& approach, Vec3 at) noexcept;

  body::Heights heights;
  int first_row, end_row;  ///< [first, end)
  body::Turn turn;
  double nearest, farthest;  ///< Bounds of the body's distance from the axis.
  body::Approach approach;
  double slanting;  ///< Factor on a distance from the axis, for its part along an element's ray.
};

/// The part of a row that such a body may touch.
struct SolidReach {
  double y;               ///< Height in the row where the section is taken, m.
  float share;            ///< Share of the row's height that the body covers, 0..1.
  body::Outline outline;  ///< Outline of the section there.
  BlockRun ranges[2];
  int used;  ///< How many of `ranges`.
};

/// Figures that rows share if an upright body has the same cut in all of them.
struct AlikeRows {
  AlikeRows() = default;
  explicit AlikeRows(const body::Outline& outline) noexcept;

  body::Outline outline;
  float distance = 0, radius = 0,
        tangent = 0;  ///< Of the circle that contains the cut, m; radius <= 0: none.
  double angle = 0;   ///< Angle of its middle.
};

/// Sets the middle of the part of row `j` that the body covers, and its share of the row. False if
/// the body cannot reach the row's `side` face.
bool cover_row(const Clay& clay, const SolidWindow& window, WallSide side, int j,
               SolidReach& row) noexcept;

/// Finds the elements that the outlines can reach, for up to eight rows from `first`. Their y,
/// share and outline must be set if `covered`. Never leaves out an element.
void plan_rows(const Clay& clay, const SolidWindow& window, WallSide side, int first, int count,
               const bool* covered, SolidReach* rows) noexcept;
/// The same for rows that are all alike. Does not read their outlines.
void plan_alike_rows(const Clay& clay, const SolidWindow& window, WallSide side,
                     const AlikeRows& alike, int first, int count, const bool* covered,
                     SolidReach* rows) noexcept;

}  // namespace onggi::contact
