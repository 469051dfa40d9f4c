#include "kiosk/collection/textures/srgb.h"

#include <gtest/gtest.h>

namespace onggi::textures::srgb_test {
namespace {

// IEC 61966-2-1, by hand: ((0.5 + 0.055) / 1.055)^2.4.
TEST(Srgb, HalfOfAScreensValueIsAFifthOfItsLight) {
  EXPECT_NEAR(light_of_srgb(0.5), 0.2140411, 1e-7);
  EXPECT_EQ(light_of_srgb(0.0), 0.0);
  EXPECT_NEAR(light_of_srgb(1.0), 1.0, 1e-15);
}

TEST(Srgb, EachWayUndoesTheOther) {
  for (int value = 0; value <= 1000; ++value)
    EXPECT_NEAR(srgb_of_light(light_of_srgb(1e-3 * value)), 1e-3 * value, 1e-6);
}

TEST(Srgb, TheStraightPartMeetsTheCurve) {
  EXPECT_NEAR(light_of_srgb(0.04045), light_of_srgb(0.0404501), 1e-7);
  EXPECT_NEAR(srgb_of_light(0.0031308), srgb_of_light(0.00313081), 1e-6);
}

}  // namespace
}  // namespace onggi::textures::srgb_test
