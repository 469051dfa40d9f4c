#pragma once

#include <cstdint>

#include "engine/math/vectors.h"

namespace onggi {

/// What effects do to some elements of many rows, one row after the other, with the same bits on
/// all kinds of vectors: what a row takes from the last is at hand, and nothing is set up for each.
/// Arrays by row have an entry for each of `rows`, from the lowest up; arrays to work with have all
/// elements of each. Padding (clay.h) is left as it is. Any thread, no allocation.
namespace column_kernels {

/// Eights of columns that are worked together: a few cache lines of each row, so that a fine grid's
/// long rows are not gone through once for every eight; and few enough for what is carried from row
/// to row to stay near.
inline constexpr int kMostBlocks = 4;

/// Where the elements are: of stored row 0, and which stored row stands at each place.
struct Columns {
  bool outside;
  int blocks = 0;  ///< Of eight elements side by side, 1..kMostBlocks.
  int rows = 0;
  int stride = 0;               ///< Floats from one stored row to the next.
  const int* stored = nullptr;  ///< Of each row.
  float* face = nullptr;        ///< The face that is worked,
  float* other = nullptr;       ///< and the one behind it.
  float wall_min = 0.0f;        ///< m
};

/// Rows that are evened together: Smoothing.
struct Even {
  Columns at;
  const float* weight = nullptr;   ///< The row's height, m,
  float per_weight = 0.0f;         ///< and one over that of all, 1/m.
  const float* flow = nullptr;     ///< To the row above, m; 0 of the last.
  const float* inverse = nullptr;  ///< Of Thomas' pivots.
  const float* up = nullptr;       ///< flow times inverse.
  float* change = nullptr;         ///< To work with.
  double* gained = nullptr;        ///< Grows by what each row's squares of radii did.
  float* rounded = nullptr;  ///< What is owed to each radius, of stored row 0, m; null: nothing is.
  float* extent = nullptr;   ///< Of each row: the largest, or inside smallest, radius written.
  float hole_min = 0.0f;     ///< No inner radius gets smaller, m.
};

/// How a row may move.
enum class Give : std::uint8_t {
  free,
  firm,   ///< Its wall moves as a whole.
  rigid,  ///< Not at all.
};

/// Rows that drag each other along: Propagation. Metres.
struct Drag {
  Columns at;
  int first = 0, end = 0;         ///< Rows that were pressed; those beyond may be dragged.
  int hollow_from = 0;            ///< Rows below have no other face.
  float* moved = nullptr;         ///< Displacements, of stored row 0.
  const float* fading = nullptr;  ///< Of each row, from the one below it.
  const Give* give = nullptr;     ///< Of each row; null: all are free.
  float along = 0.0f;             ///< As in FaceMove, and these: row_kernels.h.
  float near = 0.0f, far = 0.0f;
  float back_near = 0.0f, back_far = 0.0f;
  float* more = nullptr;       ///< To work with.
  double* lost = nullptr;      ///< Grows by the squares of radii that each row lost.
  float* outermost = nullptr;  ///< Of each row, what was written: the largest
  float* innermost = nullptr;  ///< and the smallest radius.
};
/// Rows whose displacements may have grown.
struct Dragged {
  int from = 0, to = 0;  ///< [from, to)
};

/// On one kind of vectors.
struct Table {
  /// True where an element changed.
  bool (*even)(const Even& work);
  Dragged (*drag)(const Drag& work);
};
/// One of vectors_here().
const Table& of(Vectors kind) noexcept;

}  // namespace column_kernels
}  // namespace onggi
