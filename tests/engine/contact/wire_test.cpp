#include "engine/contact/wire.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::wire_test {
namespace {

Clay lump(int sectors = 360) {
  ClayDef def;
  def.sectors = sectors;
  return std::move(*Clay::create(def));
}

// A wire along z drawn from `begin` to `end` along x, studio frame, on a wheel at `speed`.
struct Drawn {
  WireHand hand;
  double angle = 0.0;
  double work = 0.0;      // J against the drag
  double heaviest = 0.0;  // N

  void draw(WireCut& cut, const Clay& clay, double begin, double end, double length = 0.4,
            double speed = 0.0, double height = 0.002) {
    constexpr double kStep = 0.0001;  // m in a tick of 1 ms
    const int ticks = static_cast<int>(std::fabs(end - begin) / kStep + 0.5);
    for (int n = 0; n < ticks; ++n) {
      const double way = end > begin ? kStep : -kStep;
      const Vec3 from{begin + way * n, height, 0.0};
      angle += 0.001 * speed;
      const Press felt = cut.draw(
          clay, {from, from + Vec3{way, 0, 0}, {0, 0, 1}, length, angle, 0.001}, hand, 5e6);
      EXPECT_LE(felt.force.x * way, 0.0);
      work -= felt.force.x * way;
      heaviest = std::max(heaviest, std::fabs(felt.force.x));
    }
  }
};

TEST(Wire, DrawnThroughUnderThePotCutsItFree) {
  const Clay clay = lump();
  WireCut cut(360);
  Drawn drawn;
  drawn.draw(cut, clay, 0.08, -0.05);
  EXPECT_FALSE(cut.free());
  EXPECT_GT(cut.share(), 0.9);
  EXPECT_EQ(cut.height(), 0.002);
  drawn.draw(cut, clay, -0.05, -0.06);
  EXPECT_TRUE(cut.free());
  EXPECT_EQ(cut.share(), 1.0);
}

TEST(Wire, CutsAndDragsAsMuchWhicheverWayItIsDrawn) {
  const Clay clay = lump();
  const auto drawn = [&](double angle, double& drag) {
    const Vec3 way{-std::cos(angle), 0.0, -std::sin(angle)};
    WireCut cut(360);
    WireHand hand;
    for (int n = 0; n < 900; ++n) {
      const Vec3 from = Vec3{0.0, 0.002, 0.0} + (1e-4 * n - 0.08) * way;
      const Press felt = cut.draw(
          clay, {from, from + 1e-4 * way, {-way.z, 0.0, way.x}, 0.4, 0.0, 0.001}, hand, 5e6);
      drag = -dot(felt.force, way);
    }
    return cut.share();
  };
  double straight = 0.0;
  const double share = drawn(0.0, straight);
  EXPECT_GT(share, 0.5);
  EXPECT_LT(share, 0.9);
  EXPECT_GT(straight, 0.0);
  for (const double angle : {0.7, 2.2, 3.9, 5.6}) {
    double drag = 0.0;
    EXPECT_NEAR(drawn(angle, drag), share, 0.01) << angle;
    EXPECT_NEAR(drag / straight, 1.0, 0.03) << angle;
  }
}

// Half of a disc is cut when the wire stands at the axis; a segment's share elsewhere.
TEST(Wire, HasCutTheSegmentOfTheDiscThatItHasPassed) {
  for (const int sectors : {90, 1440}) {
    const Clay clay = lump(sectors);
    WireCut cut(sectors);
    Drawn drawn;
    double at = 0.07;
    for (const double next : {0.04, 0.02, 0.0, -0.03}) {
      drawn.draw(cut, clay, at, next);
      at = next;
      const double half = std::acos(at / 0.055);
      const double segment = (half - std::sin(half) * std::cos(half)) / 3.14159265358979;
      EXPECT_NEAR(cut.share(), segment, sectors == 90 ? 0.02 : 0.002) << at;
    }
  }
}

// 20 N for each metre of clay before it, at 5e6 N/m^3: 2.2 N across a disc of 110 mm; the work is
// that of the whole area.
TEST(Wire, DragsInProportionToTheClayBeforeIt) {
  const Clay clay = lump();
  WireCut cut(360);
  Drawn drawn;
  drawn.draw(cut, clay, 0.08, -0.08);
  const double most = 20.0 * 0.11;
  const double smoothed = 0.1 / std::sqrt(0.1 * 0.1 + 0.01 * 0.01);
  EXPECT_NEAR(drawn.heaviest, most * smoothed, 0.02 * most);
  EXPECT_NEAR(drawn.work, 20.0 * 3.14159265358979 * 0.055 * 0.055 * smoothed, 0.003);
}

TEST(Wire, HeldAtTheAxisOfATurningPotCutsItFreeInATurn) {
  const Clay clay = lump();
  WireCut cut(360);
  Drawn drawn;
  drawn.draw(cut, clay, 0.08, 0.02, 0.4, 6.0);
  for (int n = 0; n < 1100; ++n) drawn.draw(cut, clay, 0.02, 0.0199, 0.4, 6.0);
  const double ring = 1.0 - 0.02 * 0.02 / (0.055 * 0.055);
  EXPECT_NEAR(cut.share(), ring, 0.03);
  drawn.draw(cut, clay, 0.02, -0.001, 0.4, 6.0);
  drawn.draw(cut, clay, -0.001, -0.0011, 0.4, 6.0);
  for (int n = 0; n < 700; ++n) drawn.draw(cut, clay, -0.001, -0.0011, 0.4, 6.0);
  EXPECT_TRUE(cut.free());
}

TEST(Wire, ThatBeginsWithinTheClayCutsNothing) {
  const Clay clay = lump();
  WireCut cut(360);
  Drawn drawn;
  drawn.draw(cut, clay, 0.03, -0.05);
  EXPECT_FALSE(cut.begun());
  EXPECT_EQ(cut.share(), 0.0);
  EXPECT_EQ(drawn.heaviest, 0.0);
}

TEST(Wire, ShorterThanThePotLeavesItHanging) {
  const Clay clay = lump();
  WireCut cut(360);
  Drawn drawn;
  drawn.draw(cut, clay, 0.08, -0.08, 0.06);
  EXPECT_FALSE(cut.free());
  EXPECT_GT(cut.share(), 0.5);
  EXPECT_LT(cut.share(), 0.9);
}

TEST(Wire, ANewLumpIsWhole) {
  const Clay clay = lump();
  WireCut cut(360);
  StateHash fresh, used;
  cut.add_to(fresh);
  Drawn drawn;
  drawn.draw(cut, clay, 0.08, -0.08);
  cut.forget();
  cut.add_to(used);
  EXPECT_EQ(fresh.value(), used.value());
  EXPECT_EQ(cut.share(), 0.0);
}

}  // namespace
}  // namespace onggi::wire_test
