#pragma once

#include <cstdint>
#include <ctime>

namespace onggi::files {

/// What the clock on the wall shows, seconds since 1970. Of those who date, count and forget; who
/// waits asks a clock that never goes back. Any thread.
std::time_t wall_now();

/// From now on wall_now() shows `seconds` more than the machine's clock, in all: so days pass in an
/// hour of a soak. Any thread.
void set_wall_ahead(std::int64_t seconds);

}  // namespace onggi::files
