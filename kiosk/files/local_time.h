#pragma once

#include <ctime>
#include <string>

namespace onggi::files {

/// `at` as a clock on the wall of this machine's time zone shows it, in strftime's `format`, 63
/// bytes at most ("" beyond). Any thread.
std::string local_time(std::time_t at, const char* format);

/// "2026-05-04", as visits are counted by.
inline constexpr const char* kDay = "%Y-%m-%d";
/// "2026-05-04_141503", as folders and files are named: the order of names is that of time.
inline constexpr const char* kStamp = "%Y-%m-%d_%H%M%S";

}  // namespace onggi::files
