#include "kiosk/ground/files/local_time.h"

#include <gtest/gtest.h>

#include "tests/kiosk/ground/files/disk.h"

namespace onggi::files::local_time_test {
namespace {

TEST(LocalTime, IsWhatAClockOnTheWallOfTheMuseumShows) {
  const auto shown_in = [](const char* zone, std::time_t at, const char* format,
                           const std::string& expected) {
    return test::in_child([&] {
      ::setenv("TZ", zone, 1);
      ::tzset();
      return local_time(at, format) == expected;
    });
  };
  // 2026-05-04 15:30:07 UTC, past midnight in Seoul.
  constexpr std::time_t kAt = 1777908607;
  EXPECT_EQ(shown_in("UTC0", kAt, kStamp, "2026-05-04_153007"), 0);
  EXPECT_EQ(shown_in("KST-9", kAt, kDay, "2026-05-05"), 0);
  EXPECT_EQ(shown_in("KST-9", kAt, "%H", "00"), 0);
  EXPECT_EQ(local_time(kAt, std::string(70, '.').c_str()), "") << "too long for it";
}

}  // namespace
}  // namespace onggi::files::local_time_test
