#pragma once

#include "kiosk/picture/drawing/vessel_sheet.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// The sheet drawn on paper, 2400 pixels wide and as high as the vessel asks: section left, view
/// right, axis, scale bar, diameters, what was left out, and the figures below. Pango and Cairo
/// alone: no display, no GPU. Allocates; any thread.
view::Image draw_sheet(const VesselSheet& sheet);

}  // namespace onggi::drawing
