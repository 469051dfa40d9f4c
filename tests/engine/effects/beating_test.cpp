// Blows between paddle and anvil: what they cost in energy, and what they do to the wall.
#include "engine/effects/beating.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"
#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::beating_test {
namespace {

using namespace effects_test;

constexpr double kWall = 0.008, kOuter = 0.060;

// An upright wall, 120 mm high.
SceneDef wall(int rows = 120, int sectors = 180) {
  SceneDef def;
  each_effect(def, [](auto& effect) { effect.reset(); });
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.height = 0.120;
  def.clay.floor_thickness = 0.010;
  def.clay.outer_radius = kOuter;
  def.clay.inner_radius = kOuter - kWall;
  def.clay.wall_min = 0.001;
  def.wheel.acceleration = 1000.0;
  def.volume.emplace();
  def.beating.emplace();
  return def;
}

// A hand with a paddle in front of the wall, which it does not touch.
HandInput paddle(double height = 0.06, double angle = 0.0, bool anvil = true) {
  HandInput hand;
  const double out = kOuter + 0.012;
  hand.position = {out * portable::cos(angle), height, out * portable::sin(angle)};
  hand.active = hand.paddle = true;
  hand.anvil = anvil ? 1.0 : 0.0;
  return hand;
}

// Strikes once, and returns what the hand was told while the paddle lay there.
HandFeedback strike(Scene& scene, const HandInput& hand, double tick = 0.001) {
  Hands hands;
  hands.hand[0] = hand;
  scene.step(hands, tick);
  hands.hand[0].blow = true;
  const HandFeedback felt = scene.step(hands, tick).hand[0];
  hands.hand[0].blow = false;
  scene.step(hands, tick);  // now heights follow
  return felt;
}

double thickness(const Clay& clay, int j, std::size_t i) {
  return double{clay.outer(j)[i]} - double{clay.inner(j)[i]};
}
int row_at(const Clay& clay, double height) { return clay.first_row_above(height); }

struct Middle {
  double outer, wall;
};
Middle middle_of(const Scene& scene, double height = 0.06) {
  const int j = row_at(scene.clay(), height);
  return {double{scene.clay().outer(j)[0]}, thickness(scene.clay(), j, 0)};
}

TEST(ABlow, SpendsItsEnergyOnTheClayThatItThins) {
  for (const double energy : {0.01, 0.03, 0.1}) {
    SceneDef def = wall(240, 360);
    def.beating->energy = energy;
    Scene scene = made(def);
    const std::vector<double> heights(scene.clay().row_thicknesses().begin(),
                                      scene.clay().row_thicknesses().end());
    strike(scene, paddle());
    // Of each element: stress times ln(before / after) times its volume, and the press of the rough
    // faces on a disc of 20 mm.
    const double sector = kOuter * 2.0 * portable::kPi / 360;
    double logs = 0.0;
    for (int j = scene.clay().floor_rows(); j < scene.clay().rows(); ++j)
      for (std::size_t i = 0; i < 360; ++i)
        logs += std::log(kWall / thickness(scene.clay(), j, i)) * kWall * sector *
                heights[static_cast<std::size_t>(j)];
    const double pressure = 80e3 * (1.0 + 2.0 * 0.02 / (3.0 * std::sqrt(3.0) * kWall));
    EXPECT_NEAR(pressure * logs / energy, 1.0, 0.01) << energy;
  }
}

// A wall with a ridge for each coil, outside and inside, and a paddle that strikes it.
struct Ridged {
  static constexpr double kPitch = 0.0116, kRidge = 0.0005;  // m
  SceneDef def = wall(240, 120);
  Clay clay;
  Beating beating = Beating::make(def, clay);

  Ridged() : clay(std::move(*Clay::create(wall(240, 120).clay))) {
    clay.keep_areas();
    for (int j = clay.floor_rows(); j < clay.rows(); ++j) {
      const double proud =
          kRidge * portable::cos(2.0 * portable::kPi * clay.row_height(j) / kPitch);
      for (float& r : clay.outer_mut(j)) r += static_cast<float>(proud);
      for (float& r : clay.inner_mut(j)) r -= static_cast<float>(proud);
    }
  }
  void strike(double angle, double energy) {
    def.beating->energy = energy;
    RowTick tick;
    tick.blow[0] = {true,
                    {0.07 * portable::cos(angle), 0.06, 0.07 * portable::sin(angle)},
                    WallSide::outside,
                    0.008,
                    1.0};
    beating.run({def, clay, tick});
  }
  double outer(double height, std::size_t i = 0) const {
    return double{clay.outer(clay.first_row_above(height))[i]};
  }
};

TEST(ABlow, MeetsWhatStandsOutFirst) {
  Ridged pot;
  const double top = 5 * Ridged::kPitch, valley = 5.5 * Ridged::kPitch;  // about the middle
  const double ridge = pot.outer(top) - pot.outer(valley);
  EXPECT_NEAR(ridge, 2.0 * Ridged::kRidge, 5e-5);
  const double before = pot.outer(valley, 0) - pot.outer(valley, 60);
  pot.strike(0.0, 0.003);
  EXPECT_NEAR(pot.outer(valley, 0) - pot.outer(valley, 60), before, 1e-7)
      << "the paddle lies above";
  EXPECT_LT(pot.outer(top) - pot.outer(valley), 0.95 * ridge);
  for (int n = 0; n < 120; ++n) pot.strike(2.0 * portable::kPi * n / 15.0, 0.03);
  EXPECT_LT(pot.outer(top) - pot.outer(valley), 0.2 * ridge) << "beaten even";
}

TEST(ABlow, SpendsItsEnergyOnAnUnevenWallToo) {
  for (const double energy : {0.001, 0.01, 0.1}) {
    Ridged pot;
    std::vector<double> walls;
    const auto each = [&](const auto& visit) {
      for (int j = pot.clay.floor_rows(); j < pot.clay.rows(); ++j)
        for (std::size_t i = 0; i < 120; ++i) visit(thickness(pot.clay, j, i));
    };
    each([&](double t) { walls.push_back(t); });
    pot.strike(0.0, energy);
    const double area = pot.outer(0.06, 60) * 2.0 * portable::kPi / 120 * 0.12 / 240;
    double logs = 0.0;
    std::size_t n = 0;
    each([&](double t) { logs += std::log(walls[n] / t) * walls[n] * area, ++n; });
    const double pressure = 80e3 * (1.0 + 2.0 * 0.02 / (3.0 * std::sqrt(3.0) * kWall));
    EXPECT_NEAR(pressure * logs / energy, 1.0, 0.03) << energy;
  }
}

TEST(ABlow, OnAJarOfFullSizeIsAsPottersKnowIt) {
  // 0.6 kg of paddle and hand against 1.2 kg of anvil and hand, at 2 m/s.
  SceneDef def = wall(120, 180);
  def.clay.height = 0.36;
  def.clay.outer_radius = 0.18;
  def.clay.inner_radius = 0.156;
  def.clay.radius_max = 0.4;
  def.beating->energy = 0.5 * 0.4 * 2.0 * 2.0;
  def.beating->face = 0.06;
  Scene scene = made(def);
  HandInput hand = paddle(0.18);
  hand.position.x = 0.19;
  const HandFeedback felt = strike(scene, hand);
  EXPECT_GT(felt.blow, 300.0);
  EXPECT_LT(felt.blow, 1200.0);
  const int j = row_at(scene.clay(), 0.18);
  const double mean = (0.024 - thickness(scene.clay(), j, 0)) / 3.0;  // over the face
  EXPECT_GT(mean, 0.0001);
  EXPECT_LT(mean, 0.0005);
}

TEST(ABlow, KeepsTheClay) {
  Scene scene = made(wall());
  const double before = scene.clay().volume();
  for (int n = 0; n < 200; ++n) strike(scene, paddle(0.03 + 0.0004 * n, 0.7 * n));
  EXPECT_GT(scene.clay().rim_height(), 0.125);
  EXPECT_NEAR(scene.clay().volume() / before, 1.0, 1e-7);
}

TEST(ABlow, SpreadsTheWallAsMuchRoundAsUp) {
  Scene scene = made(wall());
  struct Ring {
    double girth, thick, high;
  };
  const auto rings = [&] {
    std::vector<Ring> all;
    for (int j = scene.clay().floor_rows(); j < 120; ++j) {
      Ring ring{0.0, 0.0, scene.clay().row_thickness(j)};
      for (std::size_t i = 0; i < 180; ++i) {
        ring.girth += double{scene.clay().outer(j)[i]} + double{scene.clay().inner(j)[i]};
        ring.thick += std::log(thickness(scene.clay(), j, i)) / 180.0;
      }
      all.push_back(ring);
    }
    return all;
  };
  const std::vector<Ring> before = rings();
  for (int n = 0; n < 60; ++n) strike(scene, paddle(0.06, 2.0 * portable::kPi * n / 20.0));
  const std::vector<Ring> after = rings();
  double wider = 0.0, higher = 0.0, thinner = 0.0;
  for (std::size_t j = 0; j < after.size(); ++j) {
    wider += std::log(after[j].girth / before[j].girth);
    higher += std::log(after[j].high / before[j].high);
    thinner += before[j].thick - after[j].thick;
  }
  EXPECT_GT(thinner, 1.0);
  EXPECT_NEAR(wider / thinner, 0.5, 0.02);
  EXPECT_NEAR(higher / thinner, 0.5, 0.02);
}

TEST(ABlow, WithoutAnAnvilDentsTheWall) {
  Scene scene = made(wall());
  const HandFeedback felt = strike(scene, paddle(0.06, 0.0, false));
  const Middle now = middle_of(scene);
  EXPECT_NEAR(now.wall, kWall, 1e-7);
  const double load = portable::kPi * 80e3 * kWall * kWall;  // of a clamped plate
  EXPECT_NEAR(felt.blow, load, 0.01 * load);
  EXPECT_NEAR(kOuter - now.outer, 0.03 / load, 0.03 * 0.03 / load);
}

TEST(ABlow, OfTheAnvilAloneBulgesTheWall) {
  Scene scene = made(wall());
  HandInput hand = paddle(0.06, 0.0, false);
  hand.position.x = kOuter - kWall - 0.012;
  strike(scene, hand);
  const Middle now = middle_of(scene);
  EXPECT_NEAR(now.wall, kWall, 1e-7);
  EXPECT_GT(now.outer, kOuter + 0.0005);
}

TEST(ABlow, IsHeldByAHandBehindTheWallAsByAnAnvil) {
  const auto thinned = [](double apart) {
    SceneDef def = wall();
    def.walls.emplace();
    Scene scene = made(def);
    Hands hands;
    hands.hand[0] = paddle(0.06, 0.0, false);
    hands.hand[1].active = true;
    hands.hand[1].position = {kOuter - kWall - def.tool.radius + 0.0002, 0.06 + apart, 0.0};
    for (int n = 0; n < 30; ++n) scene.step(hands, 0.001);
    const double before = middle_of(scene).wall;
    hands.hand[0].blow = true;
    scene.step(hands, 0.001);
    return before - middle_of(scene).wall;
  };
  const double facing = thinned(0.0), aside = thinned(0.015), far = thinned(0.05);
  EXPECT_GT(facing, 0.0003);
  EXPECT_LT(aside, 0.8 * facing);
  EXPECT_GT(aside, 0.1 * facing);
  EXPECT_LT(far, 1e-5);
}

TEST(ABlow, OnWetClayIsWeakAndGoesDeep) {
  const auto struck = [](double wetness) {
    SceneDef def = wall();
    def.moisture.emplace().air = wetness;
    def.moisture->drying_time = 1.0;
    Scene scene = made(def);
    for (int n = 0; n < 10000; ++n) scene.step({}, 0.005);
    const double force = strike(scene, paddle()).blow;
    return Middle{force, kWall - middle_of(scene).wall};
  };
  const Middle dry = struck(0.0), wet = struck(0.5);
  EXPECT_LT(wet.outer, 0.3 * dry.outer);  // N
  EXPECT_GT(wet.wall, 2.0 * dry.wall);
}

TEST(ABlow, InTheAirOrOnSolidClayDoesNothing) {
  SceneDef solid = wall();
  solid.clay.floor_thickness = solid.clay.height;
  HandInput far = paddle();
  far.position.x = kOuter + 0.05;
  HandInput above = paddle(0.16);
  for (const auto& [def, hand] : {std::pair{wall(), far}, std::pair{wall(), above},
                                  std::pair{wall(), paddle(0.0)}, std::pair{solid, paddle()}}) {
    Scene scene = made(def);
    const std::uint64_t before = scene.clay().hash();
    HandInput low = hand;
    if (hand.position.y == 0.0) low.position.y = -0.03;
    EXPECT_EQ(strike(scene, low).blow, 0.0);
    EXPECT_EQ(scene.clay().hash(), before);
  }
}

TEST(ABlow, LandsOnceHoweverLongThePaddleLies) {
  const auto after = [](int ticks, double tick) {
    Scene scene = made(wall());
    Hands hands;
    hands.hand[0] = paddle();
    scene.step(hands, tick);
    hands.hand[0].blow = true;
    for (int n = 0; n < ticks; ++n) {
      EXPECT_TRUE(scene.step(hands, tick).hand[0].contact);
    }
    hands.hand[0].blow = false;
    EXPECT_FALSE(scene.step(hands, tick).hand[0].contact);
    return scene.clay().hash();
  };
  EXPECT_EQ(after(1, 0.001), after(200, 0.001));
  EXPECT_EQ(after(1, 0.001), after(3, 0.005));
}

TEST(ABlow, IsTheSameOnAnyGrid) {
  const auto thinned = [](int rows, int sectors) {
    Scene scene = made(wall(rows, sectors));
    strike(scene, paddle(0.06, portable::kPi / sectors));
    double least = 1.0;
    for (int j = scene.clay().floor_rows(); j < scene.clay().rows(); ++j)
      for (std::size_t i = 0; i < static_cast<std::size_t>(sectors); ++i)
        least = std::min(least, thickness(scene.clay(), j, i));
    return kWall - least;
  };
  const double fine = thinned(480, 720);
  EXPECT_NEAR(thinned(240, 360), fine, 0.01 * fine);
  EXPECT_NEAR(thinned(120, 180), fine, 0.03 * fine);
  EXPECT_NEAR(thinned(40, 72), fine, 0.15 * fine);
}

TEST(ABlow, LeavesTheThinnestWallAsItIs) {
  SceneDef def = wall();
  def.clay.wall_min = kWall - 0.0001;
  Scene scene = made(def);
  for (int n = 0; n < 50; ++n) strike(scene, paddle());
  for (int j = scene.clay().floor_rows(); j < scene.clay().rows(); ++j)
    for (std::size_t i = 0; i < 180; ++i)
      ASSERT_GT(thickness(scene.clay(), j, i), def.clay.wall_min * (1.0 - 1e-6));
}

TEST(ABlow, IsTakenBackByUndo) {
  Scene scene = made(wall());
  const double rim = scene.clay().rim_height(), before = middle_of(scene).wall;
  for (int n = 0; n < 5; ++n) strike(scene, paddle());
  EXPECT_GT(scene.clay().rim_height(), rim);
  EXPECT_TRUE(scene.can_restore());
  Hands hands;
  hands.restore = true;
  for (int n = 0; n < 1000; ++n) scene.step(hands, 0.001), hands.restore = false;
  EXPECT_NEAR(scene.clay().rim_height(), rim, 1e-9);
  EXPECT_EQ(middle_of(scene).wall, before);
}

TEST(ABlow, AfterAnUndoIsAsOnAFreshWall) {
  const auto beaten = [](bool undone) {
    Scene scene = made(wall());
    for (int n = 0; n < 5 && undone; ++n) strike(scene, paddle());
    Hands hands;
    hands.restore = undone;
    for (int n = 0; n < 1000; ++n) scene.step(hands, 0.001), hands.restore = false;
    for (int n = 0; n < 20; ++n) strike(scene, paddle(0.06, 0.3 * n));
    return Middle{double{scene.clay().outer(row_at(scene.clay(), 0.06))[90]},
                  scene.clay().rim_height()};
  };
  const Middle fresh = beaten(false), again = beaten(true);
  EXPECT_GT(fresh.outer, kOuter + 0.0005);
  EXPECT_NEAR(again.outer, fresh.outer, 1e-7);
  EXPECT_NEAR(again.wall, fresh.wall, 1e-7);  // the rim's height
}

TEST(APaddle, PressesNothingAndFindsTheWallFirm) {
  SceneDef def = wall();
  def.guard.engage_time = 0.05;
  Scene scene = made(def);
  const std::uint64_t before = scene.clay().hash();
  Hands hands;
  hands.hand[0] = paddle(0.06, 0.3);
  for (int n = 0; n < 200; ++n) scene.step(hands, 0.001);
  EXPECT_EQ(length(scene.step(hands, 0.001).hand[0].force), 0.0);
  const double reach = kOuter + def.tool.radius;
  for (const double deep : {0.0005, 0.002}) {
    const double out = reach - deep;
    hands.hand[0].position = {out * portable::cos(0.3), 0.06, out * portable::sin(0.3)};
    Feedback felt;
    for (int n = 0; n < 50; ++n) felt = scene.step(hands, 0.001);
    EXPECT_TRUE(felt.hand[0].contact);
    EXPECT_GT(dot(felt.hand[0].touch.push, hands.hand[0].position), 0.0) << "outwards";
    EXPECT_GT(felt.hand[0].touch.stiffness, 0.0);
  }
  EXPECT_EQ(scene.clay().hash(), before);
}

TEST(APaddle, FeelsTheWallWithoutAStepFromRowToRowAndRayToRay) {
  Ridged pot;  // coarse rings
  double last = -1.0, most = 0.0;
  for (double height = 0.03; height < 0.1; height += 1e-5) {
    const double angle = 3.0 * height;
    const Vec3 at{0.066 * portable::cos(angle), height, 0.066 * portable::sin(angle)};
    const double depth = wall_touched(pot.clay, at, 0.008).depth;
    if (last >= 0.0) most = std::max(most, std::fabs(depth - last));
    last = depth;
  }
  EXPECT_LT(most, 5e-6) << "10 um up, on ridges of 0.5 mm in 12 mm";
  EXPECT_GT(wall_touched(pot.clay, {0.050, 0.06, 0.0}, 0.008).depth, 0.004) << "and from inside";
  EXPECT_LT(wall_touched(pot.clay, {0.050, 0.06, 0.0}, 0.008).out.x, -0.99);
  EXPECT_EQ(wall_touched(pot.clay, {0.080, 0.06, 0.0}, 0.008).depth, 0.0);
}

TEST(ABlow, LeavesATornRowAlone) {
  Ridged pot;
  pot.clay.areas()->keep_torn();
  const int torn = pot.clay.first_row_above(0.06);
  pot.clay.areas()->tear(torn);
  const std::vector<float> before(pot.clay.outer(torn).begin(), pot.clay.outer(torn).end());
  pot.strike(0.0, 0.03);
  EXPECT_TRUE(std::ranges::equal(before, pot.clay.outer(torn)));
  EXPECT_LT(pot.outer(0.062), kOuter + Ridged::kRidge - 1e-5);
}

TEST(ABlow, FindsAnElementOnTheCoarsestGridWithTheSmallestPaddle) {
  for (int n = 0; n < 40; ++n) {
    SceneDef def = wall(8, 16);
    def.clay.floor_thickness = 0.002;
    def.beating->face = 0.005;
    Scene scene = made(def);
    EXPECT_GT(strike(scene, paddle(0.02 + 0.002 * n, 0.16 * n)).blow, 0.0) << n;
  }
}

TEST(ABlow, OfAnInvalidHandIsNone) {
  Scene scene = made(wall());
  const std::uint64_t before = scene.clay().hash();
  Hands hands;
  hands.hand[0] = paddle();
  scene.step(hands, 0.001);
  hands.hand[0].blow = true;
  hands.hand[0].position.y = std::nan("");
  EXPECT_EQ(scene.step(hands, 0.001).hand[0].blow, 0.0);
  EXPECT_EQ(scene.clay().hash(), before);
}

}  // namespace
}  // namespace onggi::effects::beating_test
