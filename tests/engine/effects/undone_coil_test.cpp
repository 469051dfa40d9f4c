// Coils that are taken back, and lumps with coils.
#include <gtest/gtest.h>

#include "tests/engine/effects/building_hands.h"
#include "tests/support/clay_shape.h"

namespace onggi::effects::undone_coil_test {
namespace {

using namespace effects_test;

TEST(UndoneCoil, UndoTakesCoilsBackAsTheyWereLaid) {
  const SceneDef def = bench();
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  go_round(scene, 0.035);
  wait(scene, 1.0);
  const auto one = test::exact_shape(scene.clay());
  const double volume = scene.clay().volume();
  go_round(scene, 0.035, 0.5);
  wait(scene, 1.0);
  const int half = laid_sectors(scene);
  go_round(scene, 0.035, 0.5, 2.0, 0.001, portable::kPi);
  wait(scene, 1.0);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_GT(scene.clay().rows(), 2 * 12);
  undo(scene);
  EXPECT_EQ(laid_sectors(scene), half) << "the second half is taken back, the first one lies";
  EXPECT_EQ(test::exact_shape(scene.clay()), one);
  undo(scene);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_EQ(test::exact_shape(scene.clay()), one);
  EXPECT_NEAR(scene.clay().volume() / volume, 1.0, 1e-12);
  while (scene.can_restore()) undo(scene);
  const auto now = test::exact_shape(scene.clay());
  ASSERT_EQ(now.size(), floor.size());
  for (std::size_t n = 0; n < now.size(); ++n) ASSERT_NEAR(now[n], floor[n], 1e-15) << n;
  EXPECT_NEAR(scene.coil().added, 0.0, 1e-15);
  EXPECT_EQ(laid_sectors(scene), 0);
}

TEST(UndoneCoil, AFreshLumpHasNoCoilsAndTakesNewOnes) {
  const SceneDef def = bench();
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  go_round(scene, 0.035, 2.5, 5.0);
  wait(scene, 0.1);
  Hands hands;
  hands.renew = true;
  wait(scene, 0.5, hands);
  EXPECT_EQ(test::exact_shape(scene.clay()), floor);
  EXPECT_EQ(laid_sectors(scene), 0);
  go_round(scene, 0.035);
  wait(scene, 0.1);
  EXPECT_GT(scene.clay().rows(), def.clay.rows);
}

TEST(UndoneCoil, AFreshLumpThatIsTakenBackHasItsCoilsAgain) {
  SceneDef def = bench();
  def.clay.inner_radius = 0.02;
  def.walls.emplace().tear_strain = 0.3;
  Scene scene = made(def);
  go_round(scene, 0.041);
  wait(scene, 0.1);
  go_round(scene, 0.041, 0.6, 1.5);
  wait(scene, 1.0);
  const auto before = test::exact_shape(scene.clay());
  const double added = scene.coil().added;
  const int half = laid_sectors(scene);
  ASSERT_GT(half, 20);
  Hands hands;
  hands.renew = true;
  wait(scene, 0.5, hands);
  EXPECT_EQ(laid_sectors(scene), 0);
  EXPECT_EQ(scene.coil().added, 0.0);
  undo(scene);
  EXPECT_EQ(test::exact_shape(scene.clay()), before);
  EXPECT_EQ(scene.coil().added, added);
  EXPECT_EQ(laid_sectors(scene), half);
  wait(scene, 0.5);
  EXPECT_FALSE(scene.step({}, 0.001).torn) << "a ring is as wide as it was laid";
}

// On a grid where a tick adds one row of ten, and a step that has lasted its longest.
TEST(UndoneCoil, ARingThatRisesForSomeTicksIsTakenBackWhole) {
  SceneDef def = bench(8, 8192);
  Scene scene = made(def);
  const auto floor = test::exact_shape(scene.clay());
  for (const double closes : {2.9935, 2.996, 2.9995}) {
    go_round(scene, 0.035, 1.0, closes);
    wait(scene, 1.0);
    EXPECT_NEAR(scene.coil().added / ring(def, 0.035), 1.0, 1e-4);
    undo(scene);
    EXPECT_EQ(scene.coil().added, 0.0) << closes;
    for (int n = 0; n < 8 && scene.can_restore(); ++n) undo(scene);
    EXPECT_EQ(scene.coil().added, 0.0);
    EXPECT_EQ(laid_sectors(scene), 0);
    ASSERT_EQ(test::exact_shape(scene.clay()).size(), floor.size());
    wait(scene, 0.5);
    ASSERT_EQ(test::exact_shape(scene.clay()).size(), floor.size()) << "nothing rises again";
  }
}

}  // namespace
}  // namespace onggi::effects::undone_coil_test
