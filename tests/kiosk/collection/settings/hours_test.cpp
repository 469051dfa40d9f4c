#include "kiosk/collection/settings/hours.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>

namespace onggi::settings::hours_test {
namespace {

Hours hours(const std::string& every_day) {
  Hours made;
  made.kept = true;
  for (auto& day : made.week) EXPECT_TRUE(read_spans(every_day, day)) << every_day;
  return made;
}

files::LocalMoment at(int year, int month, int day, int hour, int minute) {
  return {year, month, day, 60 * hour + minute};
}

TEST(Hours, AKioskIsOpenFromTheFirstMinuteAndNotInTheLast) {
  const Hours day = hours("10:00-18:00");
  EXPECT_FALSE(day.open_at(at(2026, 5, 4, 9, 59)));
  EXPECT_TRUE(day.open_at(at(2026, 5, 4, 10, 0)));
  EXPECT_TRUE(day.open_at(at(2026, 5, 4, 17, 59)));
  EXPECT_FALSE(day.open_at(at(2026, 5, 4, 18, 0)));
  EXPECT_TRUE(Hours().open_at(at(2026, 5, 4, 3, 0))) << "without hours it is always open";
  const Hours noon = hours("10:00-12:30, 14:00-24:00");
  EXPECT_FALSE(noon.open_at(at(2026, 5, 4, 13, 0)));
  EXPECT_TRUE(noon.open_at(at(2026, 5, 4, 23, 59)));
}

TEST(Hours, MondayIsMondayAndHolidaysGoBeforeIt) {
  Hours week = hours("10:00-18:00");
  week.week[0] = {};
  EXPECT_FALSE(week.open_at(at(2026, 11, 23, 12, 0))) << "a Monday";
  EXPECT_TRUE(week.open_at(at(2026, 11, 22, 12, 0))) << "a Sunday";
  week.exceptions["12-25"] = {};
  EXPECT_FALSE(week.open_at(at(2026, 12, 25, 12, 0)));
  EXPECT_FALSE(week.open_at(at(2031, 12, 25, 12, 0)));
  week.exceptions["2027-12-25"] = {{600, 720}};
  EXPECT_TRUE(week.open_at(at(2027, 12, 25, 11, 0))) << "this year's word goes before every year's";
}

TEST(Hours, ALongNightBelongsToTheEveningThatItBeganIn) {
  Hours week = hours("10:00-18:00");
  EXPECT_TRUE(read_spans("10:00-18:00, 20:00-02:00", week.week[5]));
  EXPECT_TRUE(week.open_at(at(2026, 11, 21, 23, 30))) << "Saturday";
  EXPECT_TRUE(week.open_at(at(2026, 11, 22, 1, 59))) << "Sunday";
  EXPECT_FALSE(week.open_at(at(2026, 11, 22, 2, 0)));
  EXPECT_FALSE(week.open_at(at(2026, 11, 21, 1, 0))) << "the night before was none";
  week.exceptions["2026-11-21"] = {};
  EXPECT_FALSE(week.open_at(at(2026, 11, 22, 1, 0)));
  // Over the end of a year too.
  week.exceptions["12-31"] = {{20 * 60, 60}};
  EXPECT_TRUE(week.open_at(at(2027, 1, 1, 0, 59)));
}

// In Berlin the clock goes from 2 to 3 on 2026-03-29 and from 3 to 2 on 2026-10-25.
TEST(Hours, SummerTimeOpensAndClosesAtTheHoursThatAreWritten) {
  const char* before = std::getenv("TZ");
  const std::string was = before != nullptr ? before : "";
  setenv("TZ", "CET-1CEST,M3.5.0,M10.5.0/3", 1);
  tzset();
  const Hours day = hours("10:00-18:00");
  int opened = 0, closed = 0;
  bool open = false;
  // Every minute from the noon before the first to the noon after the second.
  const std::time_t first = 1774695600, last = 1793012400;
  std::time_t opened_at = 0;
  for (std::time_t t = first; t < last; t += 60) {
    const files::LocalMoment local = files::local_moment(t);
    const bool now = day.open_at(local);
    if (t > first && now != open) {
      EXPECT_EQ(local.minute, now ? 600 : 1080);
      ++(now ? opened : closed);
      if (now) opened_at = t;
      if (!now && opened_at != 0) {
        EXPECT_EQ(t - opened_at, 8 * 3600);
      }
    }
    open = now;
  }
  EXPECT_EQ(opened, 212);
  EXPECT_EQ(closed, 212);
  // An hour that is skipped is none to open in; the kiosk opens with the next minute that there is.
  EXPECT_TRUE(hours("02:30-05:00").open_at(files::local_moment(1774746000)));
  if (was.empty())
    unsetenv("TZ");
  else
    setenv("TZ", was.c_str(), 1);
  tzset();
}

TEST(Hours, WhatIsNoHourOrDateIsRefused) {
  Hours::Spans spans{{1, 2}};
  for (const char* wrong :
       {"", "open", "10-18", "10:00-18:60", "10:00-24:01", "24:00-10:00", "10:00-10:00",
        "9:00-18:00", "10:00-18:00,", "10:00 - 18:00", "10:00-18:00x", "-1:00-05:00",
        "1:0-18:00-00", "01:00-02:00,03:00-04:00,05:00-06:00,07:00-08:00,09:00-10:00"})
    EXPECT_FALSE(read_spans(wrong, spans)) << wrong;
  EXPECT_EQ(spans, (Hours::Spans{{1, 2}})) << "and changes nothing";
  for (const char* date : {"2026-12-24", "12-25", "02-29", "2028-02-29"})
    EXPECT_TRUE(is_date(date)) << date;
  for (const char* wrong : {"2026-02-29", "13-01", "2026-00-10", "24.12.", "12-5", "2026-12-24x"})
    EXPECT_FALSE(is_date(wrong)) << wrong;
}

}  // namespace
}  // namespace onggi::settings::hours_test
