#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/row_work.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// What a ball may touch of one row.
struct RowReach {
  float above;    ///< Middle of the ball above the row, m.
  float section;  ///< Radius of the ball's cross-section with the row's plane, m.
  float width;    ///< Of an element at the section's tangents, m; 1e-9 round the axis, where
                  ///< there are none.
  float per_width;
  bool edged;          ///< Elements that the section's edges cross may be pressed.
  BlockRun ranges[2];  ///< They never share a block.
  int used;            ///< Of `ranges`: 1, or 2 where the window passes angle 0, or none.
};

/// Elements of the first `used` of `ranges`.
constexpr std::int64_t elements_in(const BlockRun* ranges, int used) {
  std::int64_t blocks = 0;
  for (int n = 0; n < used; ++n) blocks += ranges[n].end - ranges[n].begin;
  return blocks * 8;
}

/// Which elements a ball can touch: rows by height, and in each row one or two ranges of blocks
/// round the ball's angle. Clay frame, metres.
struct BallWindow {
  BallWindow(const Clay& clay, Vec3 at, double radius) noexcept;

  double height, radius;   ///< Of the ball's middle; its radius.
  double distance;         ///< Of its middle from the axis.
  double middle;           ///< Its angle, in elements, -sectors/2 .. sectors/2; 0 is the first ray.
  int first_row, end_row;  ///< The rows that it reaches, [first, end).
};

/// What can be touched, on the `side` face, of the rows `first` to `first + count - 1` (1 to
/// kPlannedRows of the window's): elements whose ray the ball meets where it passes the row's
/// extent (Clay::outer_most). None that the ball presses by 80 nm is ever left out. Which else are
/// in does not change what a press comes to.
void plan_rows(const Clay& clay, const BallWindow& window, WallSide side, int first, int count,
               RowReach* rows) noexcept;

/// The blocks that hold the elements `low` to `high`, whole numbers from -sectors to 2 sectors - 1,
/// wrapped round the axis. Gives how many of `ranges` (1 or 2) are used.
int wrapped_blocks(const Clay& clay, int low, int high, BlockRun* ranges) noexcept;

}  // namespace onggi::contact
