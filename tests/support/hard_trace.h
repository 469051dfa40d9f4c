#pragma once

#include <string>

#include "engine/math/vectors.h"

namespace onggi {

/// A thousand ticks each of random hands in random scenes, `lab::random_trial` of seeds 1 to 32:
/// any grid, any effects, numbers at the ends of their ranges, every tool. The state's hash and all
/// that the hands felt, four trials a line, as tests/golden/hard_trace.txt holds them.
std::string hard_trace(Vectors kind = best_vectors());

/// What a force device is given, in random touches of random clay: velocity, coupling, passivity,
/// overspeed and guard, for eight devices at ticks of 0.1 to 5 ms, a line each, as
/// tests/golden/handle_trace.txt holds them.
std::string handle_trace();

}  // namespace onggi
