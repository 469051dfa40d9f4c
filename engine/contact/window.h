#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi {

/// Blocks of eight elements of a row, [begin, end) in blocks.
struct BlockRange {
  int begin = 0;
  int end = 0;
};

/// What a tool may touch of one row.
struct RowReach {
  float above = 0.0f;    ///< Middle of the tool's ball above the row, m.
  float section = 0.0f;  ///< Radius of the ball's cross-section with the row's plane, m.
  float width = 0.0f;    ///< Of an element at the section's tangents, m; 1e-9 round the axis, where
                         ///< there are none.
  float per_width = 0.0f;
  bool edged = false;    ///< Elements that the section's edges cross may be pressed.
  BlockRange ranges[2];  ///< They never share a block.
  int used = 0;          ///< Of `ranges`: 1, or 2 where the window passes angle 0, or none.

  std::int64_t elements() const {
    std::int64_t blocks = 0;
    for (int n = 0; n < used; ++n) blocks += ranges[n].end - ranges[n].begin;
    return blocks * 8;
  }
};

/// Rows are planned so many at a time.
inline constexpr int kPlannedRows = 32;

/// Which elements a tool can touch that lies within a ball: rows by height, and in each row one or
/// two ranges of blocks round the tool's angle. Clay frame, metres.
struct Window {
  Window(const Clay& clay, Vec3 at, double radius) noexcept;

  double height, radius;   ///< Of the ball's middle; its radius.
  double distance;         ///< Of its middle from the axis.
  double middle;           ///< Its angle, in elements, -sectors/2 .. sectors/2; 0 is the first ray.
  int first_row, end_row;  ///< The rows that it reaches, [first, end).
};

/// What can be touched, on the `side` face, of the rows `first` to `first + count - 1` (1 to
/// kPlannedRows of the window's): elements whose ray the ball meets where it passes the row's
/// extent (Clay::outer_most). None that the ball presses by 80 nm is ever left out. Which else are
/// in does not change what a press comes to.
void plan_rows(const Clay& clay, const Window& window, WallSide side, int first, int count,
               RowReach* rows) noexcept;

/// Radius of a sphere's cross-section `dy` from its centre; -1 where there is none. Factored, so
/// that nothing cancels near the poles.
double cross_section(double radius, double dy) noexcept;

}  // namespace onggi
