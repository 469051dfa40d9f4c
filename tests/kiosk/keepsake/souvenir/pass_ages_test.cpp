#include "kiosk/keepsake/souvenir/pass_ages.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::souvenir::pass_ages_test {
namespace {

constexpr std::int64_t kGiven = 1'780'000'000, kAnHour = 3600, kADay = 24 * kAnHour;

Pass pass_for(double hours, std::int64_t from = kGiven) {
  return {"", "", from, from + static_cast<std::int64_t>(hours * kAnHour)};
}

/// Passes given every quarter of an hour from kGiven on, for `days` of so many, closed for 16 hours
/// where they are 33.
std::vector<std::int64_t> open_days(int days, int quarters = 33) {
  std::vector<std::int64_t> given;
  for (int day = 0; day < days; ++day)
    for (int quarter = 0; quarter < quarters; ++quarter)
      given.push_back(kGiven + day * kADay + quarter * kAnHour / 4);
  return given;
}

TEST(PassAges, WhereVisitsGoOnAPassIsOverWhenItsHoursAre) {
  const PassAges ages(open_days(40));
  for (const double hours : {1.0, 24.0, 720.0}) {
    const std::int64_t end = kGiven + static_cast<std::int64_t>(hours * kAnHour);
    EXPECT_FALSE(ages.over(pass_for(hours), end - 1)) << hours;
    EXPECT_TRUE(ages.over(pass_for(hours), end)) << hours;
  }
}

TEST(PassAges, AClockThatLeapsAheadTakesNothingFromTheLastPasses) {
  const PassAges ages(open_days(1, 32));
  for (const std::int64_t leap : {kADay, 40 * kADay, 4000 * kADay}) {
    EXPECT_FALSE(ages.over(pass_for(24), kGiven + leap + 8 * kAnHour - kAnHour / 2)) << leap;
    EXPECT_FALSE(ages.over(pass_for(1, kGiven + 7 * kAnHour + 45 * 60), kGiven + leap)) << leap;
    EXPECT_FALSE(ages.over(pass_for(720), kGiven + leap)) << leap;
  }
}

TEST(PassAges, AClockThatWentBackEndsNoPassAndOneThatStaysWrongEndsItsOwnPasses) {
  std::vector<std::int64_t> given = open_days(1);
  EXPECT_FALSE(PassAges(given).over(pass_for(24), kGiven - 9000 * kADay));
  // The clock goes on from ten years later.
  for (const std::int64_t at : open_days(3)) given.push_back(at + 3650 * kADay);
  const PassAges ages(given);
  EXPECT_TRUE(ages.over(pass_for(24), kGiven + 3651 * kADay));
  EXPECT_TRUE(ages.over(pass_for(24, kGiven + 3650 * kADay), kGiven + 3651 * kADay));
  EXPECT_FALSE(ages.over(pass_for(24, kGiven + 3650 * kADay), kGiven + kADay))
      << "it is right again";
}

TEST(PassAges, APassWithoutHoursOrWithDatesOfNonsenseIsOver) {
  EXPECT_TRUE(PassAges().over(pass_for(0), kGiven));
  EXPECT_TRUE(PassAges({kGiven}).over({"", "", kGiven, kGiven - kADay}, kGiven));
}

}  // namespace
}  // namespace onggi::souvenir::pass_ages_test
