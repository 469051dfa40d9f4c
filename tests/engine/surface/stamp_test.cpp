#include "engine/surface/stamp.h"

#include <gtest/gtest.h>

#include "tests/engine/surface/decorated_pots.h"

namespace onggi::surface_test::stamp_test {
namespace {

/// An L: its left side and its foot.
StampDef letter() {
  StampDef def;
  def.side = 4;
  def.picture = {255, 255, 255, 255, 255, 0, 0, 0, 255, 0, 0, 0, 128, 0, 0, 0};
  return def;
}
constexpr double kTurnOfMm = 1.0 / 1680.0 * 4;  // of the row where a cell is 0.25 mm

Surface cylinder() { return made({{{0.0, 0.0668451, 0.060}, {0.1, 0.0668451, 0.060}}}); }
int relief_at(const Surface& surface, double left_mm, double up_mm) {
  return surface.relief(static_cast<int>(200 + up_mm * 4),
                        wrapped(static_cast<int>(std::floor(left_mm * 4))));
}
std::vector<Station> up_from(const Surface& surface, double along, double turns) {
  std::vector<Station> one = straight(surface, {along, turns}, {along + 0.001, turns});
  one.resize(1);
  return one;
}

TEST(Stamp, PressesItsPictureWhereAndHowItIsHeld) {
  Surface surface = cylinder();
  done(surface, letter(), up_from(surface, 0.050, 0.0));
  // Left as seen from outside is where angles grow.
  EXPECT_EQ(relief_at(surface, 3.0, -3.0), -600);
  EXPECT_EQ(relief_at(surface, 3.0, 0.5), -600);
  EXPECT_EQ(relief_at(surface, -3.0, -3.0), -600);
  EXPECT_EQ(relief_at(surface, -3.0, 3.0), 0);
  EXPECT_EQ(relief_at(surface, 3.0, 3.0), -600 * 128 / 255);
  EXPECT_EQ(relief_at(surface, 4.3, 0.0), 0);
  EXPECT_EQ(relief_at(surface, 0.0, -4.3), 0);
}

TEST(Stamp, HeldTheOtherWayItsPictureIsTurned) {
  Surface surface = cylinder();
  // It goes towards growing angles: its up is left.
  auto one = straight(surface, {0.050, 0.0}, {0.050, kTurnOfMm});
  one.resize(1);
  done(surface, letter(), one);
  EXPECT_EQ(relief_at(surface, -3.0, -3.0), -600);  // its lower left
  EXPECT_EQ(relief_at(surface, -3.0, 3.0), -600);   // its lower right
  EXPECT_EQ(relief_at(surface, 3.0, 3.0), 0);
}

TEST(Stamp, TwiceIsOnceAndSlipGoesDownWithTheClay) {
  Surface surface = cylinder();
  done(surface, BrushDef{}, straight(surface, {0.045, 0.0}, {0.055, 0.0}));
  const Volume slip = all_slip(surface);
  done(surface, letter(), up_from(surface, 0.050, 0.0));
  const std::uint64_t hash = surface.hash();
  done(surface, letter(), up_from(surface, 0.050, 0.0));
  EXPECT_EQ(surface.hash(), hash);
  EXPECT_EQ(all_slip(surface), slip);
}

TEST(Stamp, PressureAndTheWallLimitItsDepth) {
  Surface surface = cylinder();
  std::vector<Station> one = up_from(surface, 0.050, 0.0);
  one.front().pressure = kWhole / 2;
  done(surface, letter(), one);
  EXPECT_EQ(relief_at(surface, 3.0, -3.0), -300);
  Surface thin = made({{{0.0, 0.0668451, 0.0658451}, {0.1, 0.0668451, 0.0658451}}});
  done(thin, letter(), up_from(thin, 0.050, 0.0));
  EXPECT_EQ(relief_at(thin, 3.0, -3.0), -thin.deepest(200));
}

}  // namespace
}  // namespace onggi::surface_test::stamp_test
