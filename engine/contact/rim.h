#pragma once

#include "engine/contact/ball_step.h"
#include "engine/contact/tool.h"

namespace onggi {

/// Depth below the rim over which the wall takes up a press on the rim, metres: the bending length
/// of an edge load on a thin shell of that radius and thickness, limited to 1 to 4 times the tool's
/// radius.
double rim_reach(double radius, double thickness, double tool_radius) noexcept;

/// Presses a ball on the rim for one step: the wall's law, with upright rays. The pot gets lower by
/// the pressed share of the ring; the top rows give up their height. The sectors under the ball are
/// pushed out or in, and lower rows follow less and less (engine/docs/contact.md). Marks dirty
/// rows. No allocation; O(rows within rim_reach() and those already compressed) times the sectors
/// under the ball. Same bits on every machine.
Press press_rim(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept;

}  // namespace onggi
