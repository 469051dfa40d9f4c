#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/recommend.h"

namespace onggi::tuning {

/// A grid for a scene on a machine, and what is promised of it at 1 kHz.
struct TunedGrid {
  int rows = 0, sectors = 0;
  double shape_mm = 0.0;     ///< Root mean square at most.
  double worst_mm = 0.0;     ///< At the worst place at most.
  double force_pct = 0.0;    ///< Of the force, at most.
  double tick_pct = 0.0;     ///< Of a tick, that 999 of 1000 ticks take at most.
  bool fine_enough = false;  ///< lab::Recommendation's.
  bool in_time = false;
  friend bool operator==(const TunedGrid&, const TunedGrid&) = default;
};

/// What a promise adds to what was measured: hands differ, and machines do other things besides.
inline constexpr double kErrorMargin = 1.25, kTimeMargin = 1.5;

/// How a grid is looked for.
struct TunePlan {
  /// Coarsest first, rows and sectors.
  std::vector<std::array<int, 2>> grids{{100, 90},  {150, 135},   {200, 180},
                                        {300, 270}, {400, 360},   {600, 540},
                                        {800, 720}, {1200, 1080}, {1600, 1440}};
  lab::TruthPlan truth{1900, 1500, 4000.0};
  int scene_rows = 1600;            ///< Of the scene's own finest self, at half a millisecond.
  int passes = 3;                   ///< At least one.
  std::function<bool()> give_up{};  ///< Asked now and then; true: a Problem comes back.
};

/// The grid that lab::recommend() finds for the scene `def` of that name, here and now: by a few of
/// the laboratory's scripts in the scene's clay, and by its own works, with its effects. Grids are
/// tried from the coarsest until they take twice the time they may. Seconds of work; any thread but
/// the 1 kHz one. Problem where the scene is none, where it runs on the printed model, whose grid
/// is part of it, and where it was given up (exit 1).
Result<TunedGrid> tune(const std::string& name, const SceneDef& def, const TunePlan& plan = {});

/// What the grid of `def` itself comes to, by the same measures and without a margin.
Result<TunedGrid> measure_grid(const std::string& name, const SceneDef& def,
                               const TunePlan& plan = {});

/// A curator's sentence: what is promised.
std::string words_of(const TunedGrid& grid);

}  // namespace onggi::tuning
