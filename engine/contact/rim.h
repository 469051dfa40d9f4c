#pragma once

#include "engine/contact/ball_step.h"
#include "engine/contact/tool.h"

namespace onggi {

/// How deep into the wall from the rim a press on it is taken up, metres: what an edge load bends
/// of a thin shell of that radius and thickness, and 1 to 4 times the tool's radius.
double rim_reach(double radius, double thickness, double tool_radius) noexcept;

/// Presses a ball on the rim for one step: the law of the wall, with rays that stand upright. The
/// pot gets lower by the share of the ring that is pressed, the top rows giving up their height;
/// the sectors under the ball are pushed out or in, and the rows below follow less and less
/// (engine/docs/contact.md). Marks dirty rows. No allocation; O(rows within rim_reach() and those
/// pressed together before) and, of the sectors, those under the ball. Equal bits on every machine.
Press press_rim(Clay& clay, const BallStep& step, const Yielding& yielding) noexcept;

}  // namespace onggi
