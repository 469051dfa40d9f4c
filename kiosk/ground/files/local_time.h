#pragma once

#include <ctime>
#include <string>
#include <string_view>

namespace onggi::files {

/// `at` as a clock on the wall of this machine's time zone shows it, in strftime's `format`, 63
/// bytes at most ("" beyond). Any thread.
std::string local_time(std::time_t at, const char* format);

/// What calendar and clock on the wall of this machine's time zone show.
struct LocalMoment {
  int year = 2026, month = 1, day = 1;  ///< As they are said: 1..12, 1..31.
  int minute = 0;                       ///< After midnight, 0..1439.
};
/// Any thread.
LocalMoment local_moment(std::time_t at);

/// A clock that shows an earlier year is wrong: a battery was flat. No onggi is as old.
inline constexpr int kFirstYear = 2026;

/// "2026-05-04", as visits are counted by.
inline constexpr const char* kDay = "%Y-%m-%d";
/// "2026-05-04_141503", as folders and files are named: the order of names is that of time.
inline constexpr const char* kStamp = "%Y-%m-%d_%H%M%S";

/// Whether `text` begins as `pattern` says, in which a 9 stands for any digit, and goes on after
/// it: "9999-99-99_" of what kStamp named. Any thread.
bool begins_like(std::string_view text, std::string_view pattern);

}  // namespace onggi::files
