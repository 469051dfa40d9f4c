#pragma once

#include <ctime>
#include <optional>
#include <span>
#include <string_view>

namespace onggi::files {

/// A forward jump of the clock beyond this is distrusted, s: 366 days.
inline constexpr std::time_t kJump = std::time_t{366} * 24 * 3600;
/// How long a jumped clock is distrusted, s: staff correct a wrong clock within a day.
inline constexpr std::time_t kDistrust = std::time_t{24} * 3600;

/// True if nothing should be deleted by age now: between two of `times` (s since 1970, in any
/// order), or between the last of them and `now`, there is a gap of more than kLeap, and the times
/// after the gap are younger than kDoubt. It uses only these times, so a restarted program gives
/// the same answer. Times after `now` are ignored. Any thread.
bool clock_jumped(std::span<const std::time_t> times, std::time_t now);

/// The time at the start of `stamp` ("2026-05-04_141503...", kStamp, in this machine's time zone),
/// or nothing if the text has another form. Any thread.
std::optional<std::time_t> time_of_stamp(std::string_view stamp);

}  // namespace onggi::files
