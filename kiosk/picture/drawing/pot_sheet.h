#pragma once

#include <string>
#include <vector>

#include "engine/profile/profile.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// A picture of known scale.
struct ScaledPicture {
  view::Image image;
  double pixels = 1.0;  ///< Of a metre.
};

/// A visitor's decorated pot as an archaeologist draws a vessel, as plain values. Words are in the
/// visitor's language already.
struct PotSheet {
  std::string title, subtitle;
  std::vector<std::string> facts;  ///< Lines at the foot.
  /// Each has a line behind it for a name in pen: "Thrown by", "Decorated by".
  std::vector<std::string> hands;
  bool right_to_left = false;  ///< Words and drawings change sides.
  Profile pot;                 ///< As it is kept, m. For the section; two points or more.
  ScaledPicture side;          ///< The outside from the side; its axis in the middle.
  ScaledPicture strip;         ///< The outside unrolled,
  ScaledPicture zones;         ///< and by zones, each on its cone.
  std::string side_words, strip_words, zones_words;  ///< What they are. Below each.
};

inline constexpr int kSheetWidth = 2100, kSheetHeight = 1500;  ///< 7 x 5 inches, 300 dots an inch.

/// Draws it on one page: on the reading side the wall in section, left of its axis, and the view
/// right of it; beside them strip and zones in one scale. Each scale has its bar. Needs no display.
/// Allocates; any thread, one at a time; 0.3 s.
view::Image draw_sheet(const PotSheet& sheet);

}  // namespace onggi::drawing
