#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// A pot's outside as the half of it that faces the reader: places from left to right and foot up.
struct PotFace {
  int columns = 0, rows = 0;
  double height = 0.1;        ///< From the lowest row to the highest, m.
  std::vector<float> radius;  ///< m, columns x rows.
  std::vector<float> off;     ///< How far each place is off, m.
};

/// The pot without perspective, `pixels` high on nothing, lit from the upper left, each place in
/// the tone of its error. Four samples a pixel. Allocates; any thread.
view::Image paint_pot(const PotFace& pot, int pixels);

/// From celadon (a thousandth of a millimetre and less) over plaster to iron (a millimetre and
/// more), by decades. `off` in m.
view::Color tone_of_error(double off);
/// Where on that scale an error lies, 0..1, and back.
double share_of_error(double off);
double error_from_share(double share);

}  // namespace onggi::drawing
