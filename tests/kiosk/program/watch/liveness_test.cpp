#include "kiosk/program/watch/liveness.h"

#include <gtest/gtest.h>

namespace onggi::watch::liveness_test {
namespace {

TEST(pulse, beats_while_picture_and_wheel_move) {
  Liveness pulse(5.0);
  for (int second = 0; second < 60; ++second) {
    const auto n = static_cast<std::uint64_t>(second);
    EXPECT_TRUE(pulse.beats({n, 1000 * n, n}, second)) << second;
  }
  EXPECT_EQ(pulse.standing(), "");
}

TEST(pulse, a_wheel_that_stands_is_named_though_pictures_go_on) {
  Liveness pulse(5.0);
  EXPECT_TRUE(pulse.beats({1, 700, 1}, 100.0));
  EXPECT_TRUE(pulse.beats({2, 700, 2}, 104.9));
  EXPECT_FALSE(pulse.beats({3, 700, 3}, 105.0));
  EXPECT_EQ(pulse.standing(), "the wheel's loop");
  EXPECT_TRUE(pulse.beats({4, 701, 4}, 106.0));
  EXPECT_EQ(pulse.standing(), "");
}

TEST(pulse, a_picture_that_stands_is_named_though_the_wheel_turns) {
  Liveness pulse(5.0);
  EXPECT_TRUE(pulse.beats({7, 1, 1}, 0.0));
  EXPECT_FALSE(pulse.beats({7, 5000, 2}, 5.0));
  EXPECT_EQ(pulse.standing(), "the picture");
}

TEST(pulse, a_device_that_hangs_in_its_cable_is_named_though_all_else_goes_on) {
  Liveness pulse(5.0);
  EXPECT_TRUE(pulse.beats({1, 1, 9}, 0.0));
  EXPECT_TRUE(pulse.beats({2, 2, 9}, 4.9));
  EXPECT_FALSE(pulse.beats({3, 3, 9}, 5.0));
  EXPECT_EQ(pulse.standing(), "a hand device");
  EXPECT_TRUE(pulse.beats({4, 4, 0}, 6.0)) << "it was unplugged";
}

}  // namespace
}  // namespace onggi::watch::liveness_test
