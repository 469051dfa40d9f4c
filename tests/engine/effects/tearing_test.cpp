#include "engine/effects/tearing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/clay/row_division.h"
#include "engine/contact/tool.h"
#include "engine/math/vectors.h"
#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::tearing_test {
namespace {

void look(Tearing& tearing, const SceneDef& def, Clay& clay, double seconds) {
  RowTick tick;
  tick.seconds = seconds;
  tearing.run({def, clay, tick});
}

using namespace effects_test;

// A tube whose wall is 10 mm and tears below 2.5 mm.
SceneDef tube() {
  SceneDef def;
  def.clay.rows = 80;
  def.clay.sectors = 64;
  def.clay.inner_radius = 0.045;
  def.clay.floor_thickness = 0.0;
  def.clay.wall_min = 0.002;
  def.moisture.reset();
  def.volume.emplace();
  def.walls.emplace();
  def.walls->tear_thickness = 0.0025;
  return def;
}

// Between two hands at `height`, until `room` is left of the wall; then the hands are lifted, for
// long enough that it is a step of its own.
void pinch(Scene& scene, double height, double room) {
  Hands hands;
  hands.wheel_speed = 18.0;
  const double tool = scene.def().tool.radius;
  for (int n = 0; n < 3000; ++n) {
    const double half = 0.005 - (0.005 - 0.5 * room) * std::min(n / 2000.0, 1.0);
    hands.hand[0] = {{0.050 + half + tool, height, 0}, true, SideWish::outside};
    hands.hand[1] = {{0.050 - half - tool, height, 0}, true, SideWish::inside};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = hands.hand[1].active = false;
  for (int n = 0; n < 600; ++n) scene.step(hands, 0.001);
}

void once(Scene& scene, bool Hands::*ask) {
  Hands hands;
  hands.*ask = true;
  for (int n = 0; n < 60; ++n) scene.step(hands, 0.001);
  hands.*ask = false;
  scene.step(hands, 0.001);
}

int row_at(const Scene& scene, double height) { return scene.clay().first_row_above(height); }

std::vector<int> torn_rows(const Scene& scene) {
  std::vector<int> rows;
  for (int j = 0; j < scene.clay().rows(); ++j)
    if (scene.torn(j)) rows.push_back(j);
  return rows;
}

TEST(Tearing, AWallThatIsPulledTooThinTearsWhereItIsThin) {
  Scene scene = made(tube());
  pinch(scene, 0.1, 0.004);
  EXPECT_TRUE(torn_rows(scene).empty());
  EXPECT_FALSE(scene.step({}, 0.001).torn);
  pinch(scene, 0.1, 0.0015);
  EXPECT_TRUE(scene.step({}, 0.001).torn);
  EXPECT_TRUE(scene.torn(row_at(scene, 0.1)));
  EXPECT_FALSE(scene.torn(row_at(scene, 0.05)));
  EXPECT_FALSE(scene.torn(row_at(scene, 0.15)));
}

TEST(Tearing, WhatIsTornStaysTornThoughItIsThickAgain) {
  const SceneDef def = tube();
  Result<Clay> clay = Clay::create(def.clay);
  clay->keep_areas();
  Tearing tearing(*clay);
  const auto set_wall = [&](float wall) {
    for (float& inner : clay->inner_mut(40)) inner = 0.055f - wall;
    clay->areas()->mark(40);
    for (int n = 0; n < 80; ++n) look(tearing, def, *clay, 0.001);
  };
  set_wall(0.0026f);
  EXPECT_FALSE(tearing.any());
  set_wall(0.0024f);
  EXPECT_TRUE(clay->areas()->torn(40));
  set_wall(0.02f);
  EXPECT_TRUE(clay->areas()->torn(40));
  EXPECT_TRUE(tearing.any());
}

TEST(Tearing, OneThinPlaceTearsTheRing) {
  const SceneDef def = tube();
  Result<Clay> clay = Clay::create(def.clay);
  clay->keep_areas();
  Tearing tearing(*clay);
  clay->inner_mut(40)[63] = 0.053f;
  for (int n = 0; n < 80; ++n) look(tearing, def, *clay, 0.001);
  EXPECT_TRUE(clay->areas()->torn(40));
  EXPECT_FALSE(clay->areas()->torn(41));
}

TEST(Tearing, NoToolFeelsATornRingOrMovesIt) {
  for (const ToolShape& shape : tool_shapes()) {
    if (shape.severs()) continue;
    Result<Clay> clay = Clay::create(tube().clay);
    clay->keep_areas();
    clay->areas()->keep_torn();
    for (int j = 0; j < clay->rows(); ++j) clay->areas()->tear(j);
    const ToolSize size = sized(shape, {});
    double felt = 0.0;
    for (const WallSide side : {WallSide::outside, WallSide::inside}) {
      const bool outside = side == WallSide::outside;
      const Vec3 way{outside ? -1.0 : 1.0, 0, 0};
      const Vec3 face{outside ? 0.055 : 0.045, 0.1, 0};
      ToolPlace place = hold_tool(shape, face, {}, 0.0, !outside);
      const body::Ball tip = shape.support(place, size, way);
      place.at = face + (face - (tip.middle + tip.radius * way)) + 0.001 * way;
      const Yielding yielding{0.01, 5e6, 1.0};
      const std::uint64_t before = clay->hash();
      const Press torn = shape.press(*clay, side, place, size, 0.001, yielding);
      EXPECT_EQ(torn.normal, 0.0) << shape.name;
      EXPECT_EQ(length(torn.force), 0.0) << shape.name;
      EXPECT_EQ(torn.touched, 0) << shape.name;
      EXPECT_EQ(clay->hash(), before) << shape.name;
      Clay whole = *clay;
      whole.areas()->mend();
      felt = std::max(felt, shape.press(whole, side, place, size, 0.001, yielding).normal);
    }
    EXPECT_GT(felt, 0.0) << shape.name;  // there was something to feel
  }
}

TEST(Tearing, AHandGoesThroughAWallThatItToreAndIsLeftAlone) {
  Scene scene = made(tube());
  for (const double height : {0.08, 0.085, 0.09, 0.095, 0.1, 0.105, 0.11, 0.115, 0.12})
    pinch(scene, height, 0.0015);
  const std::vector<int> rows = torn_rows(scene);
  ASSERT_FALSE(rows.empty());
  const Clay& clay = scene.clay();
  const double bottom = clay.row_height(rows.front()) - 0.5 * clay.row_thickness(rows.front());
  const double top = clay.row_height(rows.back()) + 0.5 * clay.row_thickness(rows.back());
  ASSERT_GT(top - bottom,
            2.0 * scene.def().tool.radius);  // it passes between the rings that are whole
  Hands hands;
  hands.wheel_speed = 18.0;
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0] = {{0.07 - 1e-5 * n, 0.5 * (bottom + top), 0}, true, SideWish::outside};
    const Feedback felt = scene.step(hands, 0.001);
    ASSERT_FALSE(felt.hand[0].contact) << n;
    ASSERT_EQ(length(felt.hand[0].force), 0.0) << n;
  }
}

TEST(Tearing, AWallThatIsOpenedTooFarTearsAndACollaredOneDoesNot) {
  SceneDef def = tube();
  def.walls->tear_thickness = 0.0;
  def.walls->tear_strain = 0.2;
  const auto press = [&](WallSide side, double way) {
    Scene scene = made(def);
    const bool outside = side == WallSide::outside;
    Hands hands;
    hands.wheel_speed = 18.0;
    for (int n = 0; n < 3000; ++n) {
      const double gone = way * std::min(n / 2000.0, 1.0);
      hands.hand[0] = {{outside ? 0.063 - gone : 0.037 + gone, 0.1, 0},
                       true,
                       outside ? SideWish::outside : SideWish::inside};
      scene.step(hands, 0.001);
    }
    return torn_rows(scene);
  };
  EXPECT_TRUE(press(WallSide::inside, 0.007).empty());  // 15 %
  EXPECT_FALSE(press(WallSide::inside, 0.013).empty());
  EXPECT_TRUE(press(WallSide::outside, 0.013).empty());
}

TEST(Tearing, ARingThatLiesOffTheMiddleIsNoWider) {
  SceneDef def = tube();
  def.walls->tear_thickness = 0.0;
  def.walls->tear_strain = 1e-4;
  def.wobble.emplace();
  Scene scene = made(def);
  once(scene, &Hands::renew);
  for (int n = 0; n < 100; ++n) scene.step({}, 0.001);
  EXPECT_TRUE(torn_rows(scene).empty());
}

TEST(Tearing, TakingTheStepBackMendsWhatItToreAndNothingElse) {
  Scene scene = made(tube());
  pinch(scene, 0.06, 0.0015);
  const std::vector<int> first = torn_rows(scene);
  ASSERT_FALSE(first.empty());
  pinch(scene, 0.15, 0.0015);
  EXPECT_GT(torn_rows(scene).size(), first.size());
  // A pinch of more than three seconds is two steps of the history.
  for (int n = 0; n < 4 && torn_rows(scene) != first; ++n) once(scene, &Hands::restore);
  EXPECT_EQ(torn_rows(scene), first);
  while (scene.can_restore()) once(scene, &Hands::restore);
  EXPECT_TRUE(torn_rows(scene).empty());
  EXPECT_EQ(scene.clay().outer(row_at(scene, 0.06))[0], 0.055f);
}

TEST(Tearing, WhatWasDoneAfterATearGoesWithItInOneStepBack) {
  Scene scene = made(tube());
  pinch(scene, 0.06, 0.0015);
  ASSERT_FALSE(torn_rows(scene).empty());
  for (const double height : {0.12, 0.16}) pinch(scene, height, 0.006);
  ASSERT_NE(scene.clay().outer(row_at(scene, 0.16))[0], 0.055f);
  once(scene, &Hands::restore);
  EXPECT_EQ(scene.clay().outer(row_at(scene, 0.12))[0], 0.055f);
  EXPECT_EQ(scene.clay().outer(row_at(scene, 0.16))[0], 0.055f);
  EXPECT_TRUE(torn_rows(scene).empty());
}

TEST(Tearing, ATornPotThatSagsForAWhileIsWholeAfterOneStepBack) {
  SceneDef def = tube();
  def.slump.emplace();
  def.slump->yield_stress = 1500.0;
  def.slump->viscosity = 2e5;
  Scene scene = made(def);
  pinch(scene, 0.1, 0.0015);
  ASSERT_FALSE(torn_rows(scene).empty());
  Hands hands;
  for (int n = 0; n < 12000; ++n) scene.step(hands, 0.001);
  ASSERT_GT(scene.step(hands, 0.001).sinking, 0.0);
  ASSERT_FALSE(scene.fallen());
  once(scene, &Hands::restore);
  EXPECT_TRUE(torn_rows(scene).empty());
}

TEST(Tearing, ARowThatCameInTheStepTakenBackLeavesNoTear) {
  const SceneDef def = tube();
  Clay clay = std::move(*Clay::create(def.clay, best_vectors(), 8));
  clay.keep_areas();
  Tearing tearing(clay);
  constexpr int kRow = 40;
  clay::divide_row(clay, kRow, clay.areas()->of(kRow) * clay.row_thickness(kRow));
  tearing.row_divided(clay, {kRow});
  std::ranges::fill(clay.inner_mut(kRow + 1), 0.0535f);
  // Found at once, it counts with the step before the one that has just begun.
  look(tearing, def, clay, 0.2);
  ASSERT_TRUE(clay.areas()->torn(kRow + 1));
  clay.erase_row(kRow + 1);
  tearing.go_back(clay, 1);
  EXPECT_FALSE(tearing.any());
  for (int j = 0; j < clay.rows(); ++j) EXPECT_FALSE(clay.areas()->torn(j)) << j;
}

TEST(Tearing, AFreshLumpIsWholeAndTheOneBeforeItComesBackTorn) {
  Scene scene = made(tube());
  pinch(scene, 0.1, 0.0015);
  const std::vector<int> torn = torn_rows(scene);
  ASSERT_FALSE(torn.empty());
  once(scene, &Hands::renew);
  for (int n = 0; n < 600; ++n) scene.step({}, 0.001);
  EXPECT_TRUE(torn_rows(scene).empty());
  pinch(scene, 0.14, 0.0015);
  EXPECT_FALSE(torn_rows(scene).empty());
  for (int n = 0; n < 6 && torn_rows(scene) != torn; ++n) once(scene, &Hands::restore);
  EXPECT_EQ(torn_rows(scene), torn);
}

TEST(Tearing, WithoutAHistoryAFreshLumpIsWholeEveryTime) {
  SceneDef def = tube();
  def.clay.keep_undo = false;
  Scene scene = made(def);
  for (int lump = 0; lump < 12; ++lump) {
    pinch(scene, 0.1, 0.0015);
    ASSERT_FALSE(torn_rows(scene).empty()) << lump;
    once(scene, &Hands::renew);
    ASSERT_TRUE(torn_rows(scene).empty()) << lump;
  }
}

TEST(Tearing, WhatCouldTearAndDoesNotIsThrownBitForBitAsWhatCannot) {
  const auto thrown = [](double strain) {
    SceneDef def = tube();
    def.walls->tear_thickness = 0.0;
    def.walls->tear_strain = strain;
    Scene scene = made(def);
    RandomHands hands(5);
    StateHash felt;
    for (int n = 0; n < 6000; ++n)
      for (const HandFeedback& hand : scene.step(hands.next(), hands.seconds()).hand)
        for (const double f : {hand.force.x, hand.force.y, hand.force.z}) felt.add(f);
    felt.add(scene.clay().hash());
    return felt.value();
  };
  EXPECT_EQ(thrown(10.0), thrown(0.0));
}

TEST(Tearing, WhateverHandsDoNothingHealsAndNoFaceCrossesTheOther) {
  for (const bool volume : {true, false}) {
    SceneDef def = tube();
    def.walls->tear_thickness = 0.004;
    def.walls->tear_strain = 0.3;
    def.propagation.emplace();
    def.springback.emplace();
    def.smoothing.emplace();
    if (!volume) def.volume.reset();
    Scene scene = made(def);
    RandomHands hands(31);
    std::vector<int> last;
    double torn_off = 0.0;
    for (int n = 0; n < 30000; ++n) {
      scene.step(hands.next(), hands.seconds());
      if (n % 500 != 0) continue;
      const std::vector<int> now = torn_rows(scene);
      // Rows that keep their clay divide and join, and then have other places: their clay is asked.
      if (!volume) {
        ASSERT_TRUE(std::ranges::includes(now, last)) << n;
      }
      double torn = 0.0;
      for (const int j : now) torn += scene.clay().measured_area(j) * scene.clay().row_thickness(j);
      if (volume) {
        ASSERT_GE(torn, 0.999 * torn_off) << n;
      }
      torn_off = torn;
      ASSERT_NO_FATAL_FAILURE(expect_whole(scene.clay())) << n;
      last = now;
    }
    EXPECT_GT(last.size(), 3u);
  }
}

TEST(Tearing, ComesToTheSameBitsOnEveryKindOfVectors) {
  const auto thrown = [](Vectors kind) {
    Scene scene = made(tube(), kind);
    pinch(scene, 0.1, 0.0015);
    EXPECT_FALSE(torn_rows(scene).empty());
    return scene.state_hash();
  };
  const std::uint64_t best = thrown(best_vectors());
  for (const Vectors kind : vectors_here()) EXPECT_EQ(thrown(kind), best) << name_of(kind);
}

TEST(Tearing, AThicknessThatNoWallGetsToIsRefusedWithARemedy) {
  SceneDef def = tube();
  def.walls->tear_thickness = def.clay.wall_min;
  const Result<void> good = validate(def);
  ASSERT_FALSE(good);
  EXPECT_EQ(good.error().where, "walls.tear_thickness");
  EXPECT_EQ(good.error().remedy,
            "Make it larger than clay.wall_min, or 0 for walls that never tear.");
}

}  // namespace
}  // namespace onggi::effects::tearing_test
