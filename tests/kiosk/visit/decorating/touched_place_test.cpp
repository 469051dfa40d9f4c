#include "kiosk/visit/decorating/touched_place.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/kiosk/visit/decorating/a_jar.h"

namespace onggi::decorating::touched_place_test {
namespace {

using surface::Surface;

constexpr double kTurn = 2.0 * 3.14159265358979323846;

struct TouchedPlace : testing::Test {
  Surface pot = *Surface::create(a_jar(), "jar");
  view::Camera camera = view::frame_pot(1920, 1080, {900, 60, 900, 960}, 0.16, 0.07);

  /// Where the middle of a row is on the screen, at an angle in the studio.
  std::pair<float, float> pixel(int row, double angle) const {
    const surface::Row& at = pot.row(row);
    return *camera.project({at.radius * std::cos(angle), at.height, at.radius * std::sin(angle)});
  }
};

TEST_F(TouchedPlace, APointOfTheWallThatFacesTheEyeIsFoundWhereItIsDrawn) {
  for (const double turned : {0.0, 1.0, -2.5})
    for (int row = 20; row < pot.rows() && pot.row(row).part == surface::Part::outside; row += 37)
      for (const double angle : {0.6, 1.2, 1.57, 2.3}) {  // the eye is at a quarter of a turn
        const auto [x, y] = pixel(row, angle);
        const auto found = place_under(camera, pot, turned, x, y);
        ASSERT_TRUE(found) << row << ' ' << angle;
        EXPECT_NEAR(found->along, 1e-6 * surface::kRowHeight * (row + 0.5), 3e-4) << angle;
        const double turns = (angle - turned) / kTurn;
        EXPECT_NEAR(std::remainder(found->turns - turns, 1.0), 0.0, 1e-3);
      }
}

TEST_F(TouchedPlace, OverTheRimTheFarInsideIsTouched) {
  int row = 0;
  while (pot.row(row).part != surface::Part::inside) ++row;
  row += 12;  // 3 mm under the lip
  const auto [x, y] = pixel(row, -1.57);
  const auto found = place_under(camera, pot, 0.0, x, y);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->along, 1e-6 * surface::kRowHeight * (row + 0.5), 5e-4);
}

TEST_F(TouchedPlace, TheBackIsHiddenByTheFront) {
  const auto [x, y] = pixel(200, -1.57);
  const auto found = place_under(camera, pot, 0.0, x, y);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->turns, 0.25, 0.01);
}

TEST_F(TouchedPlace, BesideThePotIsNothing) {
  const auto [left, y] = pixel(300, kTurn / 2);
  EXPECT_FALSE(place_under(camera, pot, 0.0, left - 30, y));
  EXPECT_FALSE(place_under(camera, pot, 0.0, 5, 5));
  EXPECT_FALSE(place_under(camera, pot, 0.0, 1400, 1075));
}

}  // namespace
}  // namespace onggi::decorating::touched_place_test
