#pragma once

#include <vector>

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

}  // namespace onggi::decorating
