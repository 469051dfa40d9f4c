#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

enum class Direction { up, down, left, right };

/// The control that an arrow leads to from `from`: the nearest one that way, counting sideways
/// distance double; where none lies that way, the next (right, down) or the one before (left, up)
/// in reading order, round and round, so that every control can be reached with one arrow alone.
/// Empty when there are no controls.
std::string step_focus(const std::vector<Control>& controls, const std::string& from,
                       Direction direction);

/// `controls` in rows as they stand on the page, from the top down, each in the order in which it
/// is read. Indices.
std::vector<std::vector<std::size_t>> rows_of(const std::vector<Control>& controls,
                                              bool right_to_left);
/// And one after the other, as Tab goes.
std::vector<Control> in_reading_order(const std::vector<Control>& controls, bool right_to_left);

}  // namespace onggi::screens
