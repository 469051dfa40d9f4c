#pragma once

#include "engine/math/vectors.h"

namespace onggi::clay {

/// Measures a row's cross-section with one kind of vectors. Any thread, no allocation.
struct AreaKernel {
  /// Sum of outer^2 - inner^2 over `width` elements (m^2), in doubles: eight partial sums, and the
  /// last elements, in the same order on all kinds.
  double (*squares)(int width, const float* outer, const float* inner);
};
/// One of vectors_here().
const AreaKernel& area_kernel(Vectors kind) noexcept;

}  // namespace onggi::clay
