#include "kiosk/ground/files/clock_jump.h"

#include <gtest/gtest.h>

#include <vector>

#include "kiosk/ground/files/local_time.h"

namespace onggi::files::clock_jump_test {
namespace {

constexpr std::time_t kDay = 24 * 3600;
constexpr std::time_t kNow = 1'800'000'000;

bool leapt(std::vector<std::time_t> days_ago) {
  for (std::time_t& at : days_ago) at = kNow - at * kDay;
  return clock_jumped(days_ago, kNow);
}

TEST(ClockLeap, AKioskThatIsUsedOrStandsStillForAYearIsNoLeap) {
  EXPECT_FALSE(leapt({}));
  EXPECT_FALSE(leapt({0, 1, 2, 30, 400, 800}));
  EXPECT_FALSE(leapt({366, 700}));
}

TEST(ClockLeap, TenYearsOnTheClockIsDoubtedUntilVisitsHaveGoneOnForADay) {
  EXPECT_TRUE(leapt({3650, 3651, 3700}));
  EXPECT_TRUE(leapt({0, 3650, 3651})) << "the first visit after it";
  std::vector<std::time_t> times{kNow - 3650 * kDay, kNow - kDistrust + 1};
  EXPECT_TRUE(clock_jumped(times, kNow));
  times.push_back(kNow - kDistrust);
  EXPECT_FALSE(clock_jumped(times, kNow)) << "a day long nobody set it right";
}

TEST(ClockLeap, AClockThatWasSetBackHasLeaptNowhere) {
  EXPECT_FALSE(leapt({-3650, -3649}));
  EXPECT_FALSE(leapt({-3650, 1, 2}));
}

TEST(ClockLeap, AStampIsTheTimeThatItWasMadeOfInSummerAndWinter) {
  for (const std::time_t at : {kNow, kNow + 91 * kDay, kNow + 182 * kDay, kNow + 273 * kDay}) {
    EXPECT_EQ(time_of_stamp(local_time(at, kStamp)), at);
    EXPECT_EQ(time_of_stamp(local_time(at, kStamp) + "_moon_jar"), at);
  }
  EXPECT_FALSE(time_of_stamp("photos"));
  EXPECT_FALSE(time_of_stamp(""));
}

}  // namespace
}  // namespace onggi::files::clock_jump_test
