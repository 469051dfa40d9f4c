#pragma once

#include <cstdint>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/contact/row_work.h"
#include "engine/math/vec.h"

namespace onggi::contact {

/// Size of a row.
struct RowShape {
  explicit RowShape(const Clay& clay) : sectors(clay.sectors()), blocks(clay.stride() / 8) {}
  int sectors, blocks;
};

/// Elements of the first `used` (1 or 2) of `ranges`.
constexpr std::int64_t elements_in(const BlockRun* ranges, int used) {
  int blocks = ranges[0].end - ranges[0].begin;
  if (used > 1) blocks += ranges[1].end - ranges[1].begin;
  return std::int64_t{8} * blocks;
}

/// Finds the blocks that contain elements `low` to `high`, wrapped round the axis. Both are whole
/// numbers from -sectors to 2 sectors - 1. Returns how many of `ranges` (1 or 2) are used.
inline int wrapped_blocks(RowShape row, int low, int high, BlockRun* ranges) noexcept {
  const int sectors = row.sectors;
  const int all = row.blocks;
  if (low >= 0 && low <= high && high < sectors) {
    ranges[0] = {low / 8, high / 8 + 1};
    return 1;
  }
  ranges[0] = {0, all};
  if (high - low + 1 >= sectors) return 1;
  const int shift = low < 0 ? sectors : low >= sectors ? -sectors : 0;
  const auto first = static_cast<unsigned>(low + shift);
  auto last = static_cast<unsigned>(high + shift);
  if (last < static_cast<unsigned>(sectors)) {
    ranges[0] = {static_cast<int>(first / 8), static_cast<int>(last / 8) + 1};
    return 1;
  }
  last -= static_cast<unsigned>(sectors);
  if (last / 8 + 1 > first / 8) return 1;  // the two ends meet in one block: the full circle
  ranges[0] = {static_cast<int>(first / 8), all};
  ranges[1] = {0, static_cast<int>(last / 8) + 1};
  return 2;
}

/// The elements that a ball can touch: rows by height, and in each row one or two ranges of blocks
/// round the ball's angle. Clay frame, metres.
struct BallWindow {
  BallWindow(const Clay& clay, Vec3 at, double radius) noexcept;

  double height, radius;   ///< Height of the ball's middle; its radius.
  double distance;         ///< From the axis to the middle.
  double middle;           ///< Angle in elements, -sectors/2 .. sectors/2; 0 is the first ray.
  int first_row, end_row;  ///< Rows it reaches, [first, end).
};

/// Finds what can be touched on the `side` face of the rows `first` to `first + count - 1` (1 to
/// kPlannedRows of the window's rows): the elements whose ray meets the ball within the row's
/// extent (Clay::outer_most). Includes every element that the ball presses by 80 nm or more. Extra
/// elements do not change the result of a press.
void plan_rows(const Clay& clay, const BallWindow& window, WallSide side, int first, int count,
               BallWindows& rows) noexcept;
/// dr/dy of the `side` face beside the ball, over half its radius above and below; 0 where it has
/// no two rows. The face between two rays is a straight line, so that this does not jump as the
/// ball goes round.
double slope_beside(const Clay& clay, const BallWindow& window, WallSide side) noexcept;
/// Finds the blocks of reached row `k`. Returns how many of `ranges` (1 or 2) are used.
inline int blocks_of(RowShape row, const BallWindows& rows, int k, BlockRun* ranges) noexcept {
  const int turns = 2 * row.sectors;
  // The element beyond the upper end covers the rounding.
  return wrapped_blocks(row, rows.low[k] - turns, rows.high[k] + 1 - turns, ranges);
}

}  // namespace onggi::contact
