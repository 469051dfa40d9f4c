#include "kiosk/ground/files/wall_clock.h"

#include <gtest/gtest.h>

namespace onggi::files::wall_clock_test {
namespace {

TEST(WallClock, IsTheMachinesUntilTimePassesAndThenSoMuchAhead) {
  const auto near = [](std::time_t ahead) {
    const std::time_t own = std::time(nullptr);
    return wall_now() - own - ahead <= 1 && wall_now() - own - ahead >= 0;
  };
  EXPECT_TRUE(near(0));
  set_wall_ahead(86'400);
  EXPECT_TRUE(near(86'400));
  set_wall_ahead(3600);
  EXPECT_TRUE(near(3600)) << "in all, not once more";
  set_wall_ahead(0);
  EXPECT_TRUE(near(0));
}

}  // namespace
}  // namespace onggi::files::wall_clock_test
