#pragma once

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/recommend.h"
#include "kiosk/lab/measure/accuracy_orders.h"
#include "kiosk/lab/measure/accuracy_plan.h"

namespace onggi::measure {

/// A setting that the stability suite broke.
struct UnstableSetting {
  lab::AccuracySetting::Model model = lab::AccuracySetting::Model::printed;
  int rows = 0, sectors = 0;
  std::string what;
};

/// The vase of the script "throw", and the error of each place.
struct AccuracyPot {
  lab::AccuracySetting setting;
  int columns = 0, rows = 0;  ///< The half that faces the reader, from left to right and foot up.
  double low = 0.0, high = 0.0;  ///< Heights of the lowest and highest row, m.
  std::vector<float> radius;     ///< m, row by row.
  std::vector<float> off;        ///< m, >= 0.
};

/// All results of `onggi lab accuracy`.
struct AccuracyReport {
  std::string machine, command;
  std::string made;  ///< Date and commit: "2026-11-23, commit bc6a5ac".
  AccuracyPlan plan;
  double seconds = 0.0;   ///< Duration.
  double truth_mm = 0.0;  ///< By which the truth differs from one half as fine, the most of all
                          ///< scripts, root mean square: no error below it means anything.
  std::vector<lab::AccuracyRow> rows;
  std::vector<AccuracyOrder> orders;
  std::vector<lab::SettingSummary> settings;  ///< For the scripts: everything but the presets.
  /// For scripts and presets: the basis of the recommendation. Neither has coils and blows.
  std::vector<lab::SettingSummary> scenes;
  std::vector<std::size_t> edge;  ///< Indices in settings.
  std::vector<UnstableSetting> unstable;
  /// Along the edge, coarsest first, and one with the printed model.
  std::vector<AccuracyPot> pots;
  lab::HumanThresholds thresholds;
  std::optional<lab::Recommendation> recommended;  ///< At 1 kHz.
};

/// Runs all of `plan` in the scripts, in a builder's and in the presets of the program's
/// config/scenes; prints progress and remaining time to `told` every two seconds. Times are the
/// thread's own. Takes minutes and memory for 6400 x 2880. Not for the 1 kHz thread. Problem if a
/// preset is not a scene.
Result<AccuracyReport> measure_accuracy(const AccuracyPlan& plan, std::FILE* told);

/// Completes `before`, which has the rows of an earlier run, its plan and its names: everything but
/// the orders, for which rows do not suffice. Nothing is timed. Half a minute. Not for the 1 kHz
/// thread.
AccuracyReport report_again(AccuracyReport before, std::FILE* told);

}  // namespace onggi::measure
