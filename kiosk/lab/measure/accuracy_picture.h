#pragma once

#include "kiosk/lab/measure/accuracy_run.h"
#include "kiosk/lab/plots/accuracy_chart.h"

namespace onggi::measure {

/// The chart of accuracy against time: our grids and those of the most expensive scene, the printed
/// model's settings as hollow marks, all other settings as a cloud, coils and blows, and the vases.
plots::AccuracyChart chart_of(const AccuracyReport& report);

}  // namespace onggi::measure
