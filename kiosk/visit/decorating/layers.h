#pragma once

#include <vector>

#include "engine/surface/surface.h"

namespace onggi::decorating {

/// What lies on the clay at one place of a pot.
struct Layers {
  struct Slip {
    int pigment = 0;         ///< In Way::pigments.
    double thickness = 0.0;  ///< m
  };
  double cut = 0.0;         ///< How much of the clay was taken away, m.
  std::vector<Slip> slips;  ///< The lowest first.
  double glaze = 0.0;       ///< m; as it has melted, once it was fired.
};

/// On a cell of `surface`, where its glaze is `glaze` m thick. Allocates.
Layers layers_on(const surface::Surface& surface, int j, int i, double glaze);

}  // namespace onggi::decorating
