#include "kiosk/program/console/patience.h"

#include <gtest/gtest.h>

#include <vector>

namespace onggi::console::patience_test {
namespace {

TEST(Patience, TheWaitDoublesUpToAMinuteAndEndsByItself) {
  Patience patience;
  std::int64_t now = 1000;
  std::vector<std::int64_t> waits;
  for (int n = 0; n < 9; ++n) {
    EXPECT_EQ(patience.wait("maria", "a", now), 0) << "nobody is locked out";
    patience.wrong("maria", "a", now);
    waits.push_back(patience.wait("maria", "a", now));
    EXPECT_EQ(patience.wait("maria", "a", now + waits.back() - 1), 1);
    now += waits.back();
  }
  EXPECT_EQ(waits, (std::vector<std::int64_t>{1, 2, 4, 8, 16, 32, 60, 60, 60}));
  patience.right("maria", "a");
  patience.wrong("maria", "a", now);
  EXPECT_EQ(patience.wait("maria", "a", now), 1);
}

TEST(Patience, AnotherNameAndAnotherAddressWaitForNothing) {
  Patience patience;
  for (int n = 0; n < 5; ++n) patience.wrong("maria", "a", 1000);
  EXPECT_EQ(patience.wait("joon", "a", 1000), 0);
  EXPECT_EQ(patience.wait("maria", "b", 1000), 0);
  EXPECT_GT(patience.wait("maria", "a", 1000), 1);
}

TEST(Patience, AClockThatIsSetBackMakesNobodyWaitLonger) {
  Patience patience;
  patience.wrong("maria", "a", 1'000'000);
  EXPECT_EQ(patience.wait("maria", "a", 0), 1);
}

TEST(Patience, AMillionNamesTakeNoMoreMemoryThanAThousandAndTheLastAreRemembered) {
  Patience patience;
  for (int n = 0; n < 100'000; ++n) patience.wrong("x" + std::to_string(n), "a", 1000 + n);
  EXPECT_EQ(patience.wait("x99999", "a", 1000 + 99'999), 1);
  EXPECT_EQ(patience.wait("x0", "a", 1000), 0);
}

}  // namespace
}  // namespace onggi::console::patience_test
