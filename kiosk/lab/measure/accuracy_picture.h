#pragma once

#include "kiosk/lab/measure/accuracy_run.h"
#include "kiosk/picture/drawing/accuracy_chart.h"

namespace onggi::measure {

/// What accuracy costs in time, to be drawn: our grids and those of the dearest scene, the printed
/// model's settings hollow, everything else that was tried as a cloud, and the vases.
drawing::AccuracyChart chart_of(const AccuracyReport& report);

}  // namespace onggi::measure
