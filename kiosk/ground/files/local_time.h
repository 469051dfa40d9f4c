#pragma once

#include <ctime>
#include <string>
#include <string_view>

namespace onggi::files {

/// `at` in this machine's time zone, in strftime's `format`; at most 63 bytes, "" if longer. Any
/// thread.
std::string local_time(std::time_t at, const char* format);

/// Local calendar date and time of day.
struct LocalMoment {
  int year = 2026, month = 1, day = 1;  ///< As people say them: 1..12, 1..31.
  int minute = 0;                       ///< After midnight, 0..1439.
};
/// Any thread.
LocalMoment local_moment(std::time_t at);

/// A clock that shows an earlier year is wrong (an empty battery), because no onggi is older.
inline constexpr int kFirstYear = 2026;

/// "2026-05-04": visits are counted by this day.
inline constexpr const char* kDay = "%Y-%m-%d";
/// "2026-05-04_141503": names of folders and files, which then sort by time.
inline constexpr const char* kStamp = "%Y-%m-%d_%H%M%S";

/// True if `text` begins like `pattern` and has more after it; a 9 in the pattern stands for any
/// digit. "9999-99-99_" matches names made with kStamp. Any thread.
bool begins_like(std::string_view text, std::string_view pattern);

}  // namespace onggi::files
