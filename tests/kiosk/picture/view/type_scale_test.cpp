#include "kiosk/picture/view/type_scale.h"

#include <gtest/gtest.h>

namespace onggi::view::type_scale_test {
namespace {

TEST(TypeScale, CapitalsSpanSevenTenthsOfADegree) {
  // A 24-inch full-HD screen (610 mm) read from 600 mm: capitals of 7.3 mm.
  const TypeScale scale = TypeScale::for_screen(1920, 1080, 610.0, 600.0);
  const double pixels_per_mm = 2202.9 / 610.0;
  EXPECT_NEAR(scale.body() * 0.714 / pixels_per_mm, 7.33, 0.2);
}

TEST(TypeScale, StepsGrowByAThird) {
  const TypeScale scale(30.0f);
  EXPECT_EQ(scale.px(0), 30.0f);
  EXPECT_NEAR(scale.px(1), 40.0f, 0.5f);
  EXPECT_NEAR(scale.px(3), 71.0f, 0.5f);
}

}  // namespace
}  // namespace onggi::view::type_scale_test
