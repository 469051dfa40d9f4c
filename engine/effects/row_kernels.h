#pragma once

#include "engine/math/vectors.h"

namespace onggi {

/// What effects do to the elements of one row, eight at a time. Same bits on all kinds of vectors.
/// Padding (clay.h) stays unchanged. Any thread, no allocation.
namespace row_kernels {

/// How a face may move: see limits_of() in move_face.h. Metres.
struct FaceMove {
  /// Whether the face is the outer one, and whether the row has a second face.
  bool outside, hollow;
  float near = 0.0f, far = 0.0f;
  float wall_min = 0.0f;
  float along = 0.0f;
  float back_near = 0.0f, back_far = 0.0f;
};
struct FaceMoved {
  float lost = 0.0f;  ///< Sum of squares of radii that the row lost.
  float outermost = 0.0f, innermost = 0.0f;
};

/// How a face springs back: all of it if less than `least` (m) is left, else the share `gone`.
struct Spring {
  FaceMove face;
  float gone = 0.0f, least = 0.0f;
};
struct Sprung {
  FaceMoved moved;
  float left = 0.0f;  ///< Largest way that an element still has to come back, m.
};

/// Sums of radius times cosine and times sine.
struct Harmonic {
  float x = 0.0f, z = 0.0f;
};

/// Moves both faces by x times cosine plus z times sine. The inner face stays within `least` and
/// `most` - wall, the outer one within a wall's thickness and `most`. A solid row is treated as if
/// it had a hole of `least`.
struct RowPush {
  bool hollow;
  float x = 0.0f, z = 0.0f;
  float least = 0.0f, most = 0.0f, wall_min = 0.0f;
};

/// The largest outer radius and the thinnest wall.
struct WallBounds {
  float farthest = 0.0f, thinnest = 0.0f;
};

/// Figures of a whole ring.
struct Ring {
  float squares = 0.0f;   ///< Sum of outer^2 + inner^2, m^2.
  float thinnest = 0.0f;  ///< Least of outer - inner, m.
};

/// The kernels for one kind of vectors.
struct Table {
  /// One row of Springback: takes the share `gone` off `left`, and moves the face back by it.
  Sprung (*spring)(const Spring& how, int stride, float* left, float* face, float* behind);
  Harmonic (*harmonic)(int stride, const float* radius, const float* ray_cos, const float* ray_sin);
  /// FaceMoved::lost is 0.
  FaceMoved (*push)(const RowPush& how, int stride, const float* ray_cos, const float* ray_sin,
                    float* outer, float* inner);
  WallBounds (*bounds)(int stride, const float* outer, const float* inner);
  /// outer' = same outer + cross inner, inner' = same inner + cross outer, at least `wall_min`
  /// apart, because rounding errors add up from sweep to sweep. FaceMoved::lost is 0.
  FaceMoved (*mix)(int stride, float same, float cross, float wall_min, float* outer, float* inner);
  Ring (*measure)(int stride, const float* outer, const float* inner);
};
/// One of vectors_here().
const Table& of(Vectors kind) noexcept;

}  // namespace row_kernels
}  // namespace onggi
