#pragma once

#include "kiosk/lab/measure/accuracy_run.h"
#include "kiosk/picture/drawing/accuracy_chart.h"

namespace onggi::measure {

/// The chart of accuracy against time: our grids and those of the most expensive scene, the printed
/// model's settings as hollow marks, all other settings as a cloud, and the vases.
drawing::AccuracyChart chart_of(const AccuracyReport& report);

}  // namespace onggi::measure
