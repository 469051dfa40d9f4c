#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "engine/base/result.h"

namespace onggi::settings {

/// How likeness becomes points: config/rubric.toml, a museum's choice. kiosk/docs/score.md explains
/// it.
struct Rubric {
  /// One measure: at most `share` of the points depend on it, and half of that share is lost if
  /// made and wanted are `half` apart.
  struct Part {
    double share = 0.0;  ///< 0..1
    double half = 1.0;   ///< In the measure's own unit, below; > 0.
    friend bool operator==(const Part&, const Part&) = default;
  };
  Part outline{1.0, 0.036};  ///< RMS distance of the outlines / size.
  Part volume{0.10, 0.50};   ///< 1 - volume in both / volume in either.
  Part belly{0.05, 0.06};    ///< Difference of radii / size; the next three likewise.
  Part mouth{0.05, 0.06};
  Part neck{0.05, 0.06};
  Part foot{0.05, 0.06};
  Part curvature{0.05, 25.0};  ///< RMS difference of turning, degrees.
  /// Share of the vessel's opening that is missing, beyond 0.15; 0.85: closed.
  Part opening{0.50, 0.30};
  Part wall{0.05, 0.40};      ///< Missing evenness / the vessel's own.
  Part round{0.10, 0.00075};  ///< RMS distance of the outer face from a circle / size.
  Part height{0.30, 0.10};    ///< Difference / the vessel's own, if size counts.
  /// An outline that is `limit` of the height away at one place has at most `points` of 100.
  struct Worst {
    double limit = 0.05, points = 89.9;
    friend bool operator==(const Worst&, const Worst&) = default;
  } worst;
  bool size_counts = false;  ///< False: the pot is first scaled to the vessel's height.
  std::array<double, 4> stars{40.0, 65.0, 88.0, 96.0};  ///< Points for two to five stars, rising.
  friend bool operator==(const Rubric&, const Rubric&) = default;
};

struct RubricRead {
  Rubric rubric;
  std::vector<Problem> problems;  ///< With file, line and column.
  int keys_checked = 0;
};

/// Reads a rubric. On problems `rubric` holds every valid value, and defaults elsewhere.
RubricRead read_rubric(const std::filesystem::path& file);

}  // namespace onggi::settings
