#pragma once

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/row_work.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// Which rows a body of faces and rods reaches, and between which angles. Clay frame, metres.
struct SolidWindow {
  /// `at` is a point of the body, `hull` holds it.
  SolidWindow(const Clay& clay, const body::Heights& heights, const body::Hull& hull,
              const body::Approach& approach, Vec3 at) noexcept;

  body::Heights heights;
  int first_row, end_row;  ///< [first, end)
  body::Turn turn;
  double nearest, farthest;  ///< Nothing of the body is nearer to the axis, or farther.
  body::Approach approach;
  double slanting;  ///< Of a distance from the axis, what is left along the ray of an element.
};

/// What of a row such a body may touch.
struct SolidReach {
  double y;               ///< Where in the row's height it is looked at, m.
  float share;            ///< How much of that height it covers, 0..1.
  body::Outline outline;  ///< Of its section there.
  BlockRun ranges[2];
  int used;  ///< Of `ranges`.
};

/// What rows have in common that a body stands upright in: they cut it alike.
struct AlikeRows {
  AlikeRows() = default;
  explicit AlikeRows(const body::Outline& outline) noexcept;

  body::Outline outline;
  float distance = 0, radius = 0, tangent = 0;  ///< Of the circle about it, m; radius <= 0: none.
  double angle = 0;                             ///< Of its middle.
};

/// The middle of the part of row `j` that the body covers, and how much of the row that is; false
/// where it cannot reach the row's `side` face.
bool cover_row(const Clay& clay, const SolidWindow& window, WallSide side, int j,
               SolidReach& row) noexcept;

/// For up to eight rows from `first` on, whose y, share and outline are known where `covered`:
/// which of their elements the outlines can reach. Never too few.
void plan_rows(const Clay& clay, const SolidWindow& window, WallSide side, int first, int count,
               const bool* covered, SolidReach* rows) noexcept;
/// The same where all of them are alike: their outlines are not asked.
void plan_alike_rows(const Clay& clay, const SolidWindow& window, WallSide side,
                     const AlikeRows& alike, int first, int count, const bool* covered,
                     SolidReach* rows) noexcept;

}  // namespace onggi::contact
