#pragma once

#include "kiosk/collection/content/glaze.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::screens {

/// A colour of light as the display shows it: for a swatch.
view::Color display(const content::LinearColor& color);

}  // namespace onggi::screens
