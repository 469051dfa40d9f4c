#pragma once

#include "kiosk/drawing/accuracy_chart.h"
#include "kiosk/measure/accuracy_run.h"

namespace onggi::measure {

/// What accuracy costs in time, to be drawn: our grids and those of the dearest scene, the printed
/// model's settings hollow, everything else that was tried as a cloud, and the vases.
drawing::AccuracyChart chart_of(const AccuracyReport& report);

}  // namespace onggi::measure
