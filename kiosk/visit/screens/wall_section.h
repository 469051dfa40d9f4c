#pragma once

#include "kiosk/collection/content/glaze.h"
#include "kiosk/visit/decorating/layers.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// The wall of a fired pot at one place, cut across: a bar to scale with clay, slips and `glaze` in
/// their colours, and each one's name and thickness beside it, from outside to inside. Speaks it.
void lay_out_wall_section(Column& column, const Desk& desk, const decoration::Way& way,
                          const decorating::Layers& layers, const content::Glaze& glaze);

}  // namespace onggi::screens
