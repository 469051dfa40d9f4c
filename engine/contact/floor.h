#pragma once

#include "engine/contact/ball_step.h"
#include "engine/contact/tool.h"

namespace onggi {

/// Presses a ball on the floor inside the pot, or on the top of a solid lump, for one step: the
/// floor gives way like the wall, but not below ClayDef::floor_min. engine/docs/contact.md gives
/// the work of opening, and the error of using one figure for the whole floor. Rows that become
/// free get a hole as wide as the tool there. Marks dirty rows. No allocation; O(sectors) for each
/// row that becomes free. Equal bits on every machine. The force points straight up.
Press press_floor(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept;

}  // namespace onggi
