#pragma once

#include "engine/contact/outline.h"
#include "engine/contact/tool.h"

namespace onggi {

/// The block that a plate of `size` is: see engine/contact/tools/bodies.h.
Block plate_block(const ToolPlace& place, const ToolSize& size) noexcept;
/// The block round a disc: its first direction is level.
Block disc_block(const ToolPlace& place, const ToolSize& size) noexcept;

/// ToolShape::ball of a capsule, a plate and a disc. Where a straight part faces `towards`, its
/// middle.
ToolBall capsule_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);
ToolBall plate_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);
ToolBall disc_ball(const ToolPlace& place, const ToolSize& size, Vec3 towards);

}  // namespace onggi
