#pragma once

#include "kiosk/picture/drawing/vessel_sheet.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// Paints the sheet, 2400 pixels wide and as high as the vessel needs: section left, view right,
/// axis, scale bar, diameters, parts that were left out, and the figures below. Uses only Pango and
/// Cairo: no display, no GPU. Allocates; any thread.
view::Image draw_sheet(const VesselSheet& sheet);

}  // namespace onggi::drawing
