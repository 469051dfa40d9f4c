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

/// The vase of the script "throw", and how far each place of it is off the true one.
struct AccuracyPot {
  lab::AccuracySetting setting;
  int columns = 0, rows = 0;  ///< The half that faces the reader, from left to right and foot up.
  double low = 0.0, high = 0.0;  ///< Heights of the lowest and highest row, m.
  std::vector<float> radius;     ///< m, row by row.
  std::vector<float> off;        ///< m, >= 0.
};

/// Everything that `onggi lab accuracy` found.
struct AccuracyReport {
  std::string machine, command;
  AccuracyPlan plan;
  double seconds = 0.0;   ///< That it took.
  double truth_mm = 0.0;  ///< By which the truth differs from one half as fine, the most of all
                          ///< scripts, root mean square: no error below it means anything.
  std::vector<lab::AccuracyRow> rows;
  std::vector<AccuracyOrder> orders;
  std::vector<lab::SettingSummary>
      settings;                             ///< Of the scripts: what all can work but the presets.
  std::vector<lab::SettingSummary> scenes;  ///< Of scripts and presets: what decides.
  std::vector<std::size_t> edge;            ///< Of settings.
  std::vector<UnstableSetting> unstable;
  std::vector<AccuracyPot> pots;  ///< Along the edge, coarsest first, and one as printed.
  lab::HumanThresholds thresholds;
  std::optional<lab::Recommendation> recommended;  ///< At 1 kHz.
};

/// Goes through all of `plan`, in the scripts and in the presets that lie in config/scenes of the
/// program; tells what is done and how long it will still take on `told`, every two seconds. Times
/// are the thread's own. Minutes; memory for 6400 x 2880. Not for the 1 kHz thread. Problem where a
/// preset is no scene.
Result<AccuracyReport> measure_accuracy(const AccuracyPlan& plan, std::FILE* told);

}  // namespace onggi::measure
