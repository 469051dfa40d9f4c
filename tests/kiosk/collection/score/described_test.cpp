#include "kiosk/collection/score/described.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/engine/profile/shapes.h"

namespace onggi::score::described_test {
namespace {

using Described = settings::Mission::Described;

Described litre() {
  Described wanted;
  wanted.volume = 0.001;
  wanted.height = Described::Bounds{0.1, 0.15};
  wanted.mouth = Described::Bounds{0.06, 0.09};
  return wanted;
}
double points(const Figures& made) { return judge_described(litre(), made, shapes::bowl()).points; }

TEST(Described, APotThatIsAsAskedHasAllPointsAndNothingToTry) {
  const Score s = judge_described(litre(), {0.001, 0.1, 0.09}, shapes::bowl());
  EXPECT_EQ(s.points, 100.0) << "bounds are included";
  EXPECT_EQ(s.stars, 5);
  EXPECT_TRUE(s.try_next.empty());
  EXPECT_TRUE(s.alike.empty());
  ASSERT_EQ(s.asked.size(), 3u);
  EXPECT_EQ(s.asked[0].key, "mission.holds");
  EXPECT_EQ(s.asked[0].places.at("litres"), "100");
  EXPECT_EQ(s.asked[1].places.at("mm"), "100");
  EXPECT_EQ(s.asked[2].places.at("most"), "90");
}

TEST(Described, HalfOfThePointsAreLostAQuarterOffInVolumeOrAnEighthBeyondABound) {
  EXPECT_NEAR(points({0.00125, 0.12, 0.08}), 50.0, 1e-9);
  EXPECT_NEAR(points({0.00075, 0.12, 0.08}), 50.0, 1e-9);
  EXPECT_NEAR(points({0.001, 0.0875, 0.08}), 50.0, 1e-9);
  EXPECT_NEAR(points({0.001, 0.12, 0.10125}), 50.0, 1e-9);
  EXPECT_NEAR(points({0.00125, 0.0875, 0.10125}), 12.5, 1e-9);
}

RC_GTEST_PROP(DescribedProperty, NearerIsNeverWorth, (const bool more)) {
  const double far = 1e-3 * *rc::gen::inRange(1, 900), near = far * 0.01 * *rc::gen::inRange(0, 99);
  const double sign = more ? 1.0 : -1.0;
  RC_ASSERT(points({0.001 * (1 + sign * near), 0.12, 0.08}) >
            points({0.001 * (1 + sign * far), 0.12, 0.08}));
}

TEST(Described, WhatIsSaidIsWhatIsFurthestOff) {
  const auto said = [](const Figures& made) { return most_off(litre(), made); };
  EXPECT_EQ(said({0.0007, 0.12, 0.08}), "mission.more");
  EXPECT_EQ(said({0.0014, 0.12, 0.08}), "mission.less");
  EXPECT_EQ(said({0.0011, 0.12, 0.045}), "mission.wider");
  EXPECT_EQ(said({0.0011, 0.12, 0.12}), "mission.closer");
  EXPECT_EQ(said({0.0011, 0.08, 0.08}), "mission.taller");
  EXPECT_EQ(said({0.0011, 0.19, 0.08}), "mission.lower");
  EXPECT_EQ(said({0.00102, 0.12, 0.08}), "mission.close");
  const Score s = judge_described(litre(), {0.0007, 0.12, 0.08}, shapes::bowl());
  ASSERT_EQ(s.try_next.size(), 1u);
  EXPECT_EQ(s.try_next[0].key, "mission.more");
}

TEST(Described, OfAPotAreItsHeightAndItsMouth) {
  const Figures f = figures_of(shapes::cylinder(0.1, 0.05, 0.04, 0.01), 0.0004);
  EXPECT_EQ(f, (Figures{0.0004, 0.1, 0.1}));
  EXPECT_EQ(figures_of({}, 0.0), Figures{});
}

}  // namespace
}  // namespace onggi::score::described_test
