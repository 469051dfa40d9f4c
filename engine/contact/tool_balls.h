#pragma once

#include "engine/contact/outline.h"
#include "engine/contact/tool.h"

namespace onggi {

/// The block that a plate of `size` is: see engine/contact/tools/bodies.h.
Block plate_block(const ToolPlace& place, const ToolSize& size) noexcept;
/// The block round a disc: its first direction is level.
Block disc_block(const ToolPlace& place, const ToolSize& size) noexcept;

/// ToolShape::reach of a ball, a capsule and a disc.
double ball_reach(const ToolSize& size) noexcept;
double capsule_reach(const ToolSize& size) noexcept;
double disc_reach(const ToolSize& size) noexcept;
/// ToolShape::grain of those that are as fine as their radius, and as their thickness.
double radius_grain(const ToolSize& size) noexcept;
double thickness_grain(const ToolSize& size) noexcept;

/// ToolShape::ball of a ball, a capsule, a plate and a disc. Where a straight part faces `towards`,
/// its middle.
ToolBall own_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);
ToolBall capsule_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);
ToolBall plate_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);
ToolBall disc_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);

}  // namespace onggi
