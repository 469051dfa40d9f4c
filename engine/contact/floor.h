#pragma once

#include "engine/contact/ball_step.h"
#include "engine/contact/tool.h"

namespace onggi {

/// Presses a ball on the floor within the pot, or on the top of a solid lump, for one step: the
/// floor gives way as the wall does, not below ClayDef::floor_min. What it takes the tool to open,
/// and how wrong one figure for the whole floor is: engine/docs/contact.md. Rows that come free get
/// a hole as wide as the tool reaches there. Marks dirty rows. No allocation; O(sectors) for each
/// row that comes free. Equal bits on every machine. The force is straight up.
Press press_floor(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept;

}  // namespace onggi
