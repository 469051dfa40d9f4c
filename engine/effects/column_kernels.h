#pragma once

#include <cstdint>

#include "engine/math/vectors.h"

namespace onggi {

/// What effects do to some elements of many rows, row after row: what a row takes from the last row
/// is at hand, and nothing is set up per row. Same bits on all kinds of vectors. Arrays by row have
/// an entry for each of `rows`, lowest first; work arrays have all elements of each row. Padding
/// (clay.h) stays unchanged. Any thread, no allocation.
namespace column_kernels {

/// Blocks of eight columns worked together: a few cache lines of each row. One block at a time
/// would go through a fine grid's long rows too often. More blocks would not keep what is carried
/// from row to row near.
inline constexpr int kMostBlocks = 4;

/// The elements: their place in stored row 0, and which stored row stands at each place.
struct Columns {
  bool outside;
  int blocks = 0;  ///< Blocks of eight elements side by side, 1..kMostBlocks.
  int rows = 0;
  int stride = 0;               ///< Floats between stored rows.
  const int* stored = nullptr;  ///< By row: index of its stored row.
  float* face = nullptr;        ///< The face that is worked,
  float* other = nullptr;       ///< and the one behind it.
  float wall_min = 0.0f;        ///< m
};

/// Rows that smoothing evens together, in the columns that moved.
struct Even {
  Columns at;
  const float* moved = nullptr;    ///< Displacements, from stored row 0: a column of zeros stays.
  const float* weight = nullptr;   ///< The row's height, m,
  float per_weight = 0.0f;         ///< and 1 / (height of all rows), 1/m.
  const float* flow = nullptr;     ///< To the row above, m; 0 for the last.
  const float* inverse = nullptr;  ///< Of the Thomas algorithm's pivots.
  const float* up = nullptr;       ///< flow times inverse.
  float* change = nullptr;         ///< Work space.
  double* gained = nullptr;        ///< By row: adds the change of its squares of radii.
  /// Rounding remainder of each radius, from stored row 0, m; null: not kept.
  float* rounded = nullptr;
  float* extent = nullptr;  ///< By row: the largest radius written, or inside the smallest.
  float hole_min = 0.0f;    ///< Smallest allowed inner radius, m.
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
  int first = 0, end = 0;         ///< Pressed rows; rows beyond may be dragged.
  int hollow_from = 0;            ///< Rows below have no second face.
  float* moved = nullptr;         ///< Displacements, from stored row 0.
  const float* fading = nullptr;  ///< By row: factor from the row below.
  const Give* give = nullptr;     ///< By row; null: all are free.
  float along = 0.0f;             ///< The same members as FaceMove (row_kernels.h):
  float near = 0.0f, far = 0.0f;
  float back_near = 0.0f, back_far = 0.0f;
  float* more = nullptr;       ///< Work space.
  double* lost = nullptr;      ///< By row: adds the squares of radii that it lost.
  float* outermost = nullptr;  ///< By row: the largest radius written
  float* innermost = nullptr;  ///< and the smallest.
};
/// Rows whose displacements may have grown.
struct Dragged {
  int from = 0, to = 0;  ///< [from, to)
};

struct Table {
  /// True if an element changed.
  bool (*even)(const Even& work);
  Dragged (*drag)(const Drag& work);
};
/// One of vectors_here().
const Table& of(Vectors kind) noexcept;

}  // namespace column_kernels
}  // namespace onggi
