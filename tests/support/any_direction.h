#pragma once

#include "engine/math/random.h"
#include "engine/math/unit.h"
#include "engine/math/vec.h"

namespace onggi::test {

/// A unit vector, every direction alike.
inline Vec3 any_direction(Random& random) {
  for (;;) {
    const Vec3 v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    if (length(v) > 0.1 && length(v) < 1.0) return unit(v);
  }
}

}  // namespace onggi::test
