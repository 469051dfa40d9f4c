#pragma once

#include <cstdint>
#include <vector>

#include "engine/lab/accuracy.h"

namespace onggi::measure {

/// What `onggi lab accuracy` goes through.
struct AccuracyPlan {
  bool quick = false;      ///< Fewer rates and combinations; the same grids but one.
  std::uint64_t seed = 1;  ///< Of the stability suite's hands.

  /// Rows and sectors, coarsest first: each twice as fine as the one before, but the last.
  std::vector<std::array<int, 2>> grids() const;
  /// Hz, slowest first, each twice the one before.
  static constexpr std::array<double, 4> kRates{500.0, 1000.0, 2000.0, 4000.0};
  /// On this grid ticks, rules and substeps are varied where not all grids are gone through.
  static constexpr std::array<int, 2> kUsual{400, 360};
  /// All settings, every one once.
  std::vector<lab::AccuracySetting> settings() const;
  /// Finer than any grid's steps, and its elements nowhere where a grid's are.
  lab::TruthPlan truth() const;
  /// Grids for the visitor's presets, and what they are compared with: rows and tick, s.
  std::vector<std::array<int, 2>> preset_grids() const;
  int preset_truth_rows() const { return quick ? 1600 : 3200; }
  double preset_truth_tick() const { return quick ? 5e-4 : 2.5e-4; }
  /// How often a tick of `setting` is timed; the least counts.
  int passes(const lab::AccuracySetting& setting) const;
};

/// About how long a setting takes in a script, in seconds of some machine: what is left is told by
/// it.
double work_of(const lab::AccuracyScript& script, const lab::AccuracySetting& setting, int passes);

}  // namespace onggi::measure
