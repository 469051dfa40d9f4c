#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/recommend.h"

namespace onggi::tuning {

/// A grid for a scene on a machine, and its guaranteed figures at 1 kHz.
struct TunedGrid {
  int rows = 0, sectors = 0;
  double shape_mm = 0.0;     ///< Largest root mean square error.
  double worst_mm = 0.0;     ///< Largest error at one place.
  double force_pct = 0.0;    ///< Largest error of the force.
  double tick_pct = 0.0;     ///< Largest share of a tick that 999 of 1000 ticks take.
  bool fine_enough = false;  ///< From lab::Recommendation.
  bool in_time = false;
  friend bool operator==(const TunedGrid&, const TunedGrid&) = default;
};

/// Margins on the measured figures, because hands differ and machines do other work.
inline constexpr double kErrorMargin = 1.25, kTimeMargin = 1.5;

/// Options of the search.
struct TunePlan {
  /// Coarsest first; rows and sectors.
  std::vector<std::array<int, 2>> grids{{100, 90},  {150, 135},   {200, 180},
                                        {300, 270}, {400, 360},   {600, 540},
                                        {800, 720}, {1200, 1080}, {1600, 1440}};
  lab::TruthPlan truth{1900, 1500, 4000.0};
  int scene_rows = 1600;  ///< Rows of the scene's own finest grid, at ticks of half a millisecond.
  int passes = 3;         ///< At least one.
  std::function<bool()> give_up{};  ///< Called now and then; true stops with a Problem.
};

/// Finds the grid that lab::recommend() chooses for the scene `def` of that name, on this machine
/// now: with some of the laboratory's scripts in the scene's clay, and its own works with its
/// effects. Tries grids from the coarsest until they take twice the allowed time. Seconds of work;
/// any thread but the 1 kHz one. Problem if the scene is invalid, if it runs on the printed model,
/// whose grid is fixed, or if it was stopped (exit 1).
Result<TunedGrid> tune(const std::string& name, const SceneDef& def, const TunePlan& plan = {});

/// The figures of `def`'s own grid, measured the same way but without a margin.
Result<TunedGrid> measure_grid(const std::string& name, const SceneDef& def,
                               const TunePlan& plan = {});

/// The guaranteed figures as a sentence for curators.
std::string words_of(const TunedGrid& grid);

}  // namespace onggi::tuning
