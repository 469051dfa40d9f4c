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

/// A glaze as it is seen over what lies `below` it: glass that takes light on its way down and back
/// (Beer-Lambert), over its own slip where it lies on clay. As the pot is drawn, without pooling.
/// `on_slip`: `below` is a slip's colour. `thickness` in m. Linear light.
content::LinearColor seen_through(const content::GlazeLook& look, content::LinearColor below,
                                  bool on_slip, double thickness);

}  // namespace onggi::screens
