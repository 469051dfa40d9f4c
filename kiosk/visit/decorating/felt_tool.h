#pragma once

#include "engine/force/decorating_tool.h"
#include "kiosk/collection/decoration/way.h"

namespace onggi::decorating {

/// What a hand at a force device feels of a way's tool on clay that is in `state`: leather-hard or
/// softer 0, drier 1. A dip and smoke are not felt; wax and a filled line are brushed, a stone and
/// a coil are rubbed as by a finger.
force::DecoratingTool felt_tool(const decoration::WayTool& tool, decoration::WayTool::State state);

}  // namespace onggi::decorating
