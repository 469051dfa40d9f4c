#pragma once

#include "engine/math/vectors.h"

namespace onggi {

/// What effects do to the elements of one row, eight at a time, with the same bits on all kinds of
/// vectors. Padding (clay.h) is left as it is. Any thread, no allocation.
namespace row_kernels {

/// How a face may move: see limits_of() in move_face.h. Metres.
struct FaceMove {
  bool outside, hollow;  ///< There is another face.
  float near = 0.0f, far = 0.0f;
  float wall_min = 0.0f;
  float along = 0.0f;
  float back_near = 0.0f, back_far = 0.0f;
};
struct FaceMoved {
  float lost = 0.0f;  ///< Sum of squares of radii that the row lost.
  float outermost = 0.0f, innermost = 0.0f;
};

/// How a face comes back: all of what is less than `least` (m), and of more the share `gone`.
struct Spring {
  FaceMove face;
  float gone = 0.0f, least = 0.0f;
};
struct Sprung {
  FaceMoved moved;
  float left = 0.0f;  ///< The most that an element has still to come back by, m.
};

/// Sums of radius times cosine and times sine.
struct Harmonic {
  float x = 0.0f, z = 0.0f;
};

/// Both faces by x times cosine and z times sine, the inner one held to `least` and `most` - wall,
/// the outer one to a wall's thickness and `most`, as if a solid row had a hole of `least`.
struct RowPush {
  bool hollow;
  float x = 0.0f, z = 0.0f;
  float least = 0.0f, most = 0.0f, wall_min = 0.0f;
};

/// The largest outer radius and the thinnest wall.
struct WallBounds {
  float farthest = 0.0f, thinnest = 0.0f;
};

/// What a ring is like all round.
struct Ring {
  float squares = 0.0f;   ///< Sum of outer^2 + inner^2, m^2.
  float thinnest = 0.0f;  ///< Least of outer - inner, m.
};

/// On one kind of vectors.
struct Table {
  /// One row of Springback: `left` less the share that is gone, and the face back by that.
  Sprung (*spring)(const Spring& how, int stride, float* left, float* face, float* behind);
  Harmonic (*harmonic)(int stride, const float* radius, const float* ray_cos, const float* ray_sin);
  /// FaceMoved::lost is 0.
  FaceMoved (*push)(const RowPush& how, int stride, const float* ray_cos, const float* ray_sin,
                    float* outer, float* inner);
  WallBounds (*bounds)(int stride, const float* outer, const float* inner);
  /// outer' = same outer + cross inner, inner' = same inner + cross outer; `wall_min` apart at the
  /// least, for roundings add up from sweep to sweep. FaceMoved::lost is 0.
  FaceMoved (*mix)(int stride, float same, float cross, float wall_min, float* outer, float* inner);
  Ring (*measure)(int stride, const float* outer, const float* inner);
};
/// One of vectors_here().
const Table& of(Vectors kind) noexcept;

}  // namespace row_kernels
}  // namespace onggi
