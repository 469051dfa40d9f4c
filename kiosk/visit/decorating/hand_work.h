#pragma once

#include <optional>
#include <vector>

#include "engine/surface/laws.h"

namespace onggi::decorating {

/// What a hand did on a pot at once, so that it can be written down.
struct HandWork {
  struct Figure {
    int figure = 0;                               ///< In Way::figures.
    double along = 0.0, turns = 0.0, size = 0.0;  ///< Its middle; its height, m.
    bool inside = false;
  };
  int tool = 0;       ///< In Way::tools.
  surface::Tool law;  ///< With its pigment, its height, its seed.
  int repeats = 1;    ///< Round the pot.
  std::optional<Figure> figure;
  /// The tool's ways over the clay, the first of the repeats. None for a figure, a dip, smoke.
  std::vector<std::vector<surface::Station>> ways;

  /// The tool's next stations: of its last way, if they begin where it ends, else of another.
  void go_on(const std::vector<surface::Station>& stations);
};

}  // namespace onggi::decorating
