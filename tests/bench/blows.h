#pragma once

#include "tests/bench/timing.h"

namespace onggi::bench {

/// The ticks in which a paddle strikes a wall of 10 mm, with the paddle of
/// config/scenes/built.toml: `blows` of them, up and round a pot of 200 mm.
Times time_blows(int rows, int sectors, int blows);

}  // namespace onggi::bench
