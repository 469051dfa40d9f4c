#pragma once

#include <cstdint>
#include <ctime>

namespace onggi::files {

/// Wall clock, seconds since 1970, for dates, counts and expiry. To wait, use a clock that never
/// goes back. Any thread.
std::time_t wall_now();

/// From now on wall_now() is `seconds` ahead of the machine's clock in total, so that days pass
/// within an hour of a soak. Any thread.
void set_wall_ahead(std::int64_t seconds);

}  // namespace onggi::files
