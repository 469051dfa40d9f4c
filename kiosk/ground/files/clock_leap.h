#pragma once

#include <ctime>
#include <optional>
#include <span>
#include <string_view>

namespace onggi::files {

/// A clock that leapt ahead by more than this looks like one that is wrong, s: 366 days.
inline constexpr std::time_t kLeap = std::time_t{366} * 24 * 3600;
/// So long is it not believed, s: whoever sees it sets it right within a day.
inline constexpr std::time_t kDoubt = std::time_t{24} * 3600;

/// True where what goes by its age had better wait: between two of `times` (s since 1970, in any
/// order), or the last of them and `now`, lie more than kLeap, and what came after it is younger
/// than kDoubt. By these times alone, so that a program that begins anew in between knows it too.
/// Times after `now` do not count. Any thread.
bool clock_leapt(std::span<const std::time_t> times, std::time_t now);

/// The time that begins `stamp` ("2026-05-04_141503...", kStamp, in this machine's time zone).
/// Nothing where it begins otherwise. Any thread.
std::optional<std::time_t> time_of_stamp(std::string_view stamp);

}  // namespace onggi::files
