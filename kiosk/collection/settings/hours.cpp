#include "kiosk/collection/settings/hours.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace onggi::settings {

namespace {

constexpr std::size_t kMostSpans = 4;

using Date = std::chrono::year_month_day;

const Hours::Spans& spans_of(const Hours& hours, const Date& date) {
  char full[24];
  std::snprintf(full, sizeof full, "%04d-%02u-%02u", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
  // An exception for this year overrides one for every year.
  for (const char* name : {full + 0, full + 5})
    if (const auto at = hours.exceptions.find(name); at != hours.exceptions.end())
      return at->second;
  const std::chrono::weekday day{std::chrono::sys_days(date)};
  return hours.week[day.iso_encoding() - 1];
}

bool read_clock(const std::string& text, int& minute) {
  int hour = 0, rest = 0, used = 0;
  if (text.size() != 5 || std::sscanf(text.c_str(), "%2d:%2d%n", &hour, &rest, &used) != 2 ||
      used != 5)
    return false;
  minute = hour * 60 + rest;
  return hour >= 0 && rest >= 0 && rest < 60 && minute <= 24 * 60;
}

}  // namespace

bool Hours::open_at(const files::LocalMoment& at) const {
  if (!kept) return true;
  const Date today{std::chrono::year(at.year), std::chrono::month(static_cast<unsigned>(at.month)),
                   std::chrono::day(static_cast<unsigned>(at.day))};
  const Date yesterday{std::chrono::sys_days(today) - std::chrono::days(1)};
  for (const Span& span : spans_of(*this, today))
    if (at.minute >= span.from && (at.minute < span.until || span.until <= span.from)) return true;
  for (const Span& span : spans_of(*this, yesterday))
    if (span.until <= span.from && at.minute < span.until) return true;
  return false;
}

bool read_spans(const std::string& text, Hours::Spans& spans) {
  Hours::Spans read;
  if (text != "closed") {
    for (std::size_t at = 0; at <= text.size();) {
      const auto comma = std::min(text.find(',', at), text.size());
      std::string one = text.substr(at, comma - at);
      while (!one.empty() && one.front() == ' ') one.erase(0, 1);
      while (!one.empty() && one.back() == ' ') one.pop_back();
      Hours::Span span;
      if (one.size() != 11 || one[5] != '-' || !read_clock(one.substr(0, 5), span.from) ||
          !read_clock(one.substr(6), span.until) || span.from == span.until ||
          span.from == 24 * 60 || read.size() == kMostSpans)
        return false;
      read.push_back(span);
      at = comma + 1;
    }
  }
  spans = std::move(read);
  return true;
}

bool is_date(const std::string& text) {
  const bool every_year = text.size() == 5;
  // Check against a leap year, which has every date.
  const std::string full = every_year ? "2028-" + text : text;
  int year = 0, used = 0;
  unsigned month = 0, day = 0;
  if (full.size() != 10 ||
      std::sscanf(full.c_str(), "%4d-%2u-%2u%n", &year, &month, &day, &used) != 3 || used != 10)
    return false;
  return Date(std::chrono::year(year), std::chrono::month(month), std::chrono::day(day)).ok();
}

}  // namespace onggi::settings
