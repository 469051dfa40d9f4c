#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

enum class Direction { up, down, left, right };

/// The control that an arrow reaches from `from`: the nearest one in that direction, by the
/// distance of edges. One that lies straight in that direction is not passed over. If there is
/// none, the next (right, down) or previous (left, up) one in reading order, cyclically, so that
/// one arrow reaches every control. Empty if there are no controls.
std::string step_focus(const std::vector<Control>& controls, const std::string& from,
                       Direction direction);

/// `controls` in rows from top to bottom, each in reading order. Indices.
std::vector<std::vector<std::size_t>> rows_of(const std::vector<Control>& controls,
                                              bool right_to_left);
/// The same as one list, in the order of Tab.
std::vector<Control> in_reading_order(const std::vector<Control>& controls, bool right_to_left);

}  // namespace onggi::screens
