#include "kiosk/exhibit/composition/rollout_views.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace onggi::exhibit::rollout_views_test {
namespace {

/// Red grows from the left, 0..250; green from the foot up, 0..250.
view::Image strip() {
  view::Image image{500, 250, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (const int value : {x / 2, image.height - 1 - y, 0, 255})
        image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

struct Pixel {
  int red, green, alpha;
};
Pixel at(const view::Image& image, int x, int y) {
  const auto n = 4u * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                       static_cast<std::size_t>(x));
  return {image.rgba[n], image.rgba[n + 1], image.rgba[n + 3]};
}

std::vector<Vec2> straight(Vec2 from, Vec2 to) {
  const std::array ends{from, to};
  return evenly_along(ends, 201);
}

TEST(RolloutViews, ACylinderUnrollsIntoItsStrip) {
  const auto outline = straight({0.05, 0.0}, {0.05, 0.1});
  const auto cones = cones_of(outline, 1e-4, 6);
  const auto image = on_cones(strip(), outline, cones, 2000.0, 0.005);
  EXPECT_NEAR(image.width, 2000.0 * 2.0 * 3.14159265 * 0.05, 1.0);
  EXPECT_NEAR(image.height, 200, 1.0);
  for (const double x : {0.1, 0.5, 0.9})
    for (const double y : {0.1, 0.5, 0.9}) {
      const Pixel here =
          at(image, static_cast<int>(x * image.width), static_cast<int>(y * image.height));
      EXPECT_EQ(here.alpha, 255);
      EXPECT_NEAR(here.red, 250.0 * x, 2.0);
      EXPECT_NEAR(here.green, 250.0 * (1.0 - y), 2.0);
    }
}

TEST(RolloutViews, AConeUnrollsIntoARingSectorOfItsAngleWithTheFootBelow) {
  // It widens by 0.6 for each metre along it, so it opens 216 degrees: more than half round.
  const auto outline = straight({0.03, 0.0}, {0.09, 0.08});
  const auto cones = cones_of(outline, 1e-4, 6);
  const auto image = on_cones(strip(), outline, cones, 2000.0, 0.005);
  const double widens = 0.6, inner = 0.03 / widens, outer = 0.09 / widens;
  EXPECT_NEAR(image.width, 2.0 * outer * 2000.0, 2.0);
  const double ends = outer * std::cos(3.14159265 * widens);  // below the tip
  EXPECT_NEAR(image.height, 2000.0 * (outer - ends), 2.0);
  const auto place = [&](double far, double turn) {
    const double angle = 2.0 * 3.14159265 * widens * turn;
    return at(image, static_cast<int>(0.5 * image.width + 2000.0 * far * std::sin(angle)),
              static_cast<int>(2000.0 * (outer - far * std::cos(angle))));
  };
  for (const double turn : {-0.4, -0.2, 0.0, 0.3}) {
    const Pixel low = place(inner + 0.01, turn), high = place(outer - 0.01, turn);
    EXPECT_EQ(low.alpha, 255);
    EXPECT_NEAR(low.red, 250.0 * (turn + 0.5), 3.0);
    EXPECT_NEAR(low.green, 25.0, 3.0) << "a tenth of the way up";
    EXPECT_NEAR(high.green, 225.0, 3.0);
  }
  EXPECT_EQ(place(inner - 0.01, 0.0).alpha, 0) << "nothing within it";
  EXPECT_EQ(at(image, image.width / 2, image.height - 2).alpha, 0) << "nor where it does not close";
}

TEST(RolloutViews, AConeThatNarrowsUpwardsStandsTheOtherWayRound) {
  const auto outline = straight({0.09, 0.0}, {0.06, 0.04});
  const auto image = on_cones(strip(), outline, cones_of(outline, 1e-4, 6), 2000.0, 0.005);
  // Its tip is above: the foot's edge, its longest, is below.
  const Pixel foot = at(image, image.width / 2, image.height - 4);
  EXPECT_EQ(foot.alpha, 255);
  EXPECT_LT(foot.green, 20);
  EXPECT_NEAR(foot.red, 125, 2);
  EXPECT_EQ(at(image, image.width / 2, 4).alpha, 0);
}

TEST(RolloutViews, ZonesStandApartAndGoOnWhereTheOneBelowEnded) {
  const std::array corners{Vec2{0.03, 0}, Vec2{0.06, 0.08}, Vec2{0.06, 0.14}};
  const auto outline = evenly_along(corners, 201);
  const auto cones = cones_of(outline, 5e-4, 6);
  ASSERT_EQ(cones.size(), 2u);
  const auto image = on_cones(strip(), outline, cones, 2000.0, 0.005);
  // Down its middle: the band, a gap of 10 pixels, the cone.
  int top = 3;  // the uppermost pixel may be covered in part
  while (at(image, image.width / 2, top).alpha > 127) ++top;
  int below = top;
  while (below < image.height && at(image, image.width / 2, below).alpha < 128) ++below;
  EXPECT_NEAR(below - top, 10, 2);
  const double meets = 250.0 * static_cast<double>(cones[0].last) / 200.0;
  EXPECT_NEAR(at(image, image.width / 2, top - 2).green, meets, 5.0);
  EXPECT_NEAR(at(image, image.width / 2, below + 2).green, meets, 5.0);
}

TEST(RolloutViews, TheSideViewHasTheOutlineAndTheStripsMiddleBeforeTheEye) {
  const std::array corners{Vec2{0.03, 0}, Vec2{0.06, 0.08}, Vec2{0.04, 0.14}};
  const auto outline = evenly_along(corners, 201);
  const auto image = side_view(strip(), outline, 0.143, 1000.0);
  EXPECT_EQ(image.width, 120);
  EXPECT_NEAR(image.height, 143, 1);
  EXPECT_EQ(at(image, 60, 1).alpha, 255) << "up to the rim";
  for (const int y : {20, 60, 100, 130}) {
    const double height = (image.height - y - 0.5) / 1000.0;
    const double r = height < 0.08 ? std::lerp(0.03, 0.06, height / 0.08)
                                   : std::lerp(0.06, 0.04, (height - 0.08) / 0.06);
    int wide = 0;
    for (int x = 0; x < image.width; ++x) wide += at(image, x, y).alpha > 127;
    EXPECT_NEAR(wide, 2000.0 * r, 2.0) << y;
  }
  // Of the strip's middle half, left is left.
  const Pixel left = at(image, 25, 60), right = at(image, 95, 60);
  EXPECT_LT(left.red, right.red);
}

}  // namespace
}  // namespace onggi::exhibit::rollout_views_test
