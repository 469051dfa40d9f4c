#pragma once

#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::plots {

/// The half of a pot's outside that faces the reader: columns from left to right, foot first.
struct PotFace {
  int columns = 0, rows = 0;
  double height = 0.1;        ///< From the lowest row to the highest, m.
  std::vector<float> radius;  ///< m, columns x rows.
  std::vector<float> off;     ///< Error of each place, m.
};

/// The pot without perspective, `pixels` high on a transparent ground, lit from the upper left,
/// each place in the colour of its error. Four samples a pixel. Allocates; any thread.
view::Image paint_pot(const PotFace& pot, int pixels);

/// From celadon (a thousandth of a millimetre or less) over plaster to iron (a millimetre or more),
/// in decades. `off` in m.
view::Color tone_of_error(double off);
/// Position of an error on that scale, 0..1, and back.
double share_of_error(double off);
double error_from_share(double share);

}  // namespace onggi::plots
