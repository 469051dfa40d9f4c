#pragma once

#include "engine/clay/block_run.h"
#include "engine/math/vectors.h"

namespace onggi {

/// What effects do to the elements of one row, eight at a time, with the same bits on all kinds of
/// vectors. Padding (clay.h) is left as it is. Any thread, no allocation.
namespace row_kernels {

/// How a face may move: see move_face(). Metres.
struct FaceMove {
  bool outside = true;
  bool hollow = true;  ///< There is another face.
  float near = 0.0f, far = 0.0f;
  float wall_min = 0.0f;
  float along = 0.0f;
  float back_near = 0.0f, back_far = 0.0f;
};
struct FaceMoved {
  float lost = 0.0f;  ///< Sum of squares of radii that the row lost.
  float outermost = 0.0f, innermost = 0.0f;
};

/// Sums of radius times cosine and times sine.
struct Harmonic {
  float x = 0.0f, z = 0.0f;
};

/// Both faces by x times cosine and z times sine, the inner one held to `least` and `most` - wall,
/// the outer one to a wall's thickness and `most`, as if a solid row had a hole of `least`.
struct RowPush {
  bool hollow = true;
  float x = 0.0f, z = 0.0f;
  float least = 0.0f, most = 0.0f, wall_min = 0.0f;
};

/// The largest outer radius and the thinnest wall.
struct WallBounds {
  float farthest = 0.0f, thinnest = 0.0f;
};

/// Eight columns of rows that are evened together, a row after the other: Smoothing. Doubles.
struct Columns {
  bool outside = true;
  int rows = 0;
  int stride = 0;                ///< Floats from one stored row to the next.
  const int* stored = nullptr;   ///< As which each row is stored, the lowest first.
  float* face = nullptr;         ///< Of stored row 0: the eight elements that are evened,
  const float* other = nullptr;  ///< and those of the other face.
  const double* weight = nullptr;
  const double* flow = nullptr;
  const double* up = nullptr;
  const double* pivot = nullptr;
  double* squares = nullptr;  ///< Eight a row, to work with.
  double* gained = nullptr;   ///< Grows by what each row's squares of radii did.
  float* extent = nullptr;    ///< Of each row: the largest, or inside smallest, radius written.
  double wall_min = 0.0;
};

/// What a ring is like all round.
struct Ring {
  float squares = 0.0f;   ///< Sum of outer^2 + inner^2, m^2.
  float thinnest = 0.0f;  ///< Least of outer - inner, m.
};

/// On one kind of vectors.
struct Table {
  FaceMoved (*move)(const FaceMove& how, BlockRun run, const float* by, float* face, float* behind);
  /// One row of Propagation::drag(): `own` becomes what follows, `more` what that is more. The
  /// largest of `more`.
  float (*pull)(BlockRun run, float faded, float* own, float* source, float* carried, float* more);
  /// One row of Springback: `left` less the share `gone` of it, all of it where it is less than
  /// `least`; `move` becomes what went, negative. The largest that is left.
  float (*spring)(int stride, float gone, float least, float* left, float* move);
  Harmonic (*harmonic)(int stride, const float* radius, const float* ray_cos, const float* ray_sin);
  /// FaceMoved::lost is 0.
  FaceMoved (*push)(const RowPush& how, int stride, const float* ray_cos, const float* ray_sin,
                    float* outer, float* inner);
  WallBounds (*bounds)(int stride, const float* outer, const float* inner);
  /// outer' = same outer + cross inner, inner' = same inner + cross outer; `wall_min` apart at the
  /// least, for roundings add up from sweep to sweep. FaceMoved::lost is 0.
  FaceMoved (*mix)(int stride, float same, float cross, float wall_min, float* outer, float* inner);
  Ring (*measure)(int stride, const float* outer, const float* inner);
  /// True where an element changed.
  bool (*even)(const Columns& columns);
};
/// One of vectors_here().
const Table& of(Vectors kind) noexcept;

}  // namespace row_kernels
}  // namespace onggi
