#pragma once

#include "engine/script/plan.h"

namespace onggi::script {

/// Scripts for what a scene's effects bring: a wall pulled up between two hands, one that falls
/// (too wet, too thin), clay that dries and is wetted again, a lump that wobbles, the lines that a
/// finger left. On a scene without the effect they do the same moves.
Plan pull_tall, collapse, dry_out, re_wet, centre, rib_smooth;

}  // namespace onggi::script
