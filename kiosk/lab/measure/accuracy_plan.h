#pragma once

#include <cstdint>
#include <vector>

#include "engine/lab/accuracy.h"

namespace onggi::measure {

/// The plan of `onggi lab accuracy`.
struct AccuracyPlan {
  bool quick = false;      ///< Fewer rates and combinations; all grids but one.
  std::uint64_t seed = 1;  ///< Seed of the stability suite's hands.

  /// Rows and sectors, coarsest first: each twice as fine as the one before, except the last.
  std::vector<std::array<int, 2>> grids() const;
  /// Hz, slowest first, each twice the one before.
  static constexpr std::array<double, 4> kRates{500.0, 1000.0, 2000.0, 4000.0};
  /// The grid for varying ticks, rules and substeps, if not all grids are used.
  static constexpr std::array<int, 2> kUsual{400, 360};
  /// All settings, each once.
  std::vector<lab::AccuracySetting> settings() const;
  /// Finer than every grid, and with elements at other places.
  lab::TruthPlan truth() const;
  /// Grids for the visitor's presets, and their reference: rows and tick, s.
  std::vector<std::array<int, 2>> preset_grids() const;
  int preset_truth_rows() const { return quick ? 1600 : 3200; }
  double preset_truth_tick() const { return quick ? 5e-4 : 2.5e-4; }
  /// How often a tick of `setting` is timed; the shortest time counts.
  int passes(const lab::AccuracySetting& setting) const;
};

/// Rough duration of a setting in a script, in seconds of some machine, to estimate the remaining
/// time.
double work_of(const lab::AccuracyScript& script, const lab::AccuracySetting& setting, int passes);

}  // namespace onggi::measure
