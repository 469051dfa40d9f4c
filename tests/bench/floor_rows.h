#pragma once

#include <span>

#include "engine/clay/wall_side.h"
#include "engine/contact/row_work.h"
#include "engine/math/vectors.h"

namespace onggi::bench {

/// One row of floor_loop().
struct FloorRow {
  float* face;
  float* behind;
  float section;  ///< Radius of the sphere's circle, m.
  BlockRun ranges[2];
  int used;
};
/// What all rows have in common. Metres.
struct FloorStep {
  const float* ray_cos;
  const float* ray_sin;
  float x, z;  ///< Of the sphere's middle.
  float gone;
  float wall_min;
};

/// On one kind of vectors.
struct FloorLoop {
  void (*press)(WallSide side, const FloorStep& step, const FloorRow* rows, int count);
};
const FloorLoop& floor_rows(Vectors kind) noexcept;

}  // namespace onggi::bench
