#pragma once

#include <string>

#include "engine/math/vectors.h"

namespace onggi {

/// Six seconds of a potter's work on a whole grid: outside, inside, on the rim, in the floor,
/// water, both hands, a fault, a renewed lump, a restored one, odd tick lengths. Gives the state's
/// hash after every second, a line each, as tests/golden/engine_trace.txt holds them, or after the
/// first `seconds` only. Empty where no scene can be made.
std::string engine_trace(int seconds = 6, Vectors kind = best_vectors());

/// Every tool in turn, outside and inside, beside a second hand, on a small grid with every effect
/// that a tick can have, then coils laid on such a wall, and blows that beat it: each tool's name
/// and the state's hash after it, a line each, as tests/golden/tools_trace.txt holds them. Empty
/// where no scene can be made.
std::string tools_trace(Vectors kind = best_vectors());

}  // namespace onggi
