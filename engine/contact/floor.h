#pragma once

#include "engine/contact/ball_step.h"
#include "engine/contact/tool.h"

namespace onggi {

/// Presses a ball on the floor inside the pot, or on the top of a solid lump, for one step. The
/// floor yields like the wall, but not below ClayDef::floor_min. engine/docs/contact.md gives the
/// work of opening, and the error of using one figure for the whole floor. A row that becomes free
/// gets a hole as wide as the tool there. The force points straight up. Marks dirty rows. No
/// allocation; O(sectors) per row that becomes free. Same bits on every machine.
Press press_floor(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept;

}  // namespace onggi
