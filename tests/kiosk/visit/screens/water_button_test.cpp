#include "kiosk/visit/screens/water_button.h"

#include <gtest/gtest.h>

namespace onggi::screens::water_button_test {
namespace {

TEST(WaterButton, WaterHelpsAfterTwentySecondsOfRubbingDryClayAndIsAskedForSixMore) {
  WaterButton water;
  const auto rub = [&water](double wetness, int seconds) {
    for (int n = 0; n < seconds; ++n) water.look(true, wetness, 1.0);
  };
  rub(0.0, 20);
  EXPECT_FALSE(water.would_help());
  for (int n = 0; n < 100; ++n) water.look(false, 0.0, 1.0);
  EXPECT_FALSE(water.would_help()) << "a hand in the air dries nothing";
  rub(0.0, 1);
  EXPECT_TRUE(water.would_help());
  EXPECT_TRUE(water.asked_for());
  rub(0.0, 5);
  EXPECT_TRUE(water.would_help());
  EXPECT_FALSE(water.asked_for());
  rub(0.1, 1);
  EXPECT_FALSE(water.would_help()) << "wet clay";
  rub(0.0, 21);
  water.set(true);
  water.look(false, 0.0, 1.0);
  EXPECT_FALSE(water.would_help()) << "the tap is open";
}

}  // namespace
}  // namespace onggi::screens::water_button_test
