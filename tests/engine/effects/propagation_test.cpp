#include "engine/effects/propagation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::propagation_test {
namespace {

using namespace effects_test;

SceneDef small() {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 64;
  def.clay.inner_radius = 0.040;
  def.propagation.emplace();
  return def;
}

// A clay of which rows alone were moved inwards, by hand.
struct Moved {
  Clay clay;
  explicit Moved(const SceneDef& def) : clay(std::move(*Clay::create(def.clay))) {
    clay.keep_areas();
    clay.keep_displacements();
  }
  void press(int j, float by) {
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      clay.outer_mut(j)[i] -= by;
      clay.displacements(false)->row(j)[i] = by;
    }
    clay.areas()->set(j, clay.measured_area(j));
    clay.displacements(false)->mark(j, {0, clay.stride() / Displacements::kBlock});
  }
  double moved(int j) const { return 0.055 - double{clay.outer(j)[5]}; }
};

// What engine/docs/effects.md says: the share of a move that a row `distance` m away follows.
double dragged_share(const PropagationDef& def, double distance) {
  const double far = std::abs(distance) / def.reach;
  const double end = std::exp(-3.0);
  return far < 3.0 ? (std::exp(-far) - end) / (1.0 - end) : 0.0;
}

TEST(Propagation, ARowDragsThoseAboveAndBelowByTheShareOfItsMove) {
  const SceneDef def = small();
  Moved m(def);
  m.press(100, 5e-4f);
  Propagation propagation(m.clay.stride());
  propagation.drag(*def.propagation, m.clay, WallSide::outside, 0.0);
  for (int j = 80; j <= 120; ++j) {
    const double share = dragged_share(*def.propagation, 0.001 * (j - 100));
    EXPECT_NEAR(m.moved(j), 5e-4 * share, 2e-8) << j;
  }
  EXPECT_EQ(m.clay.outer(113)[5], 0.055f);  // beyond three reaches
}

TEST(Propagation, NoRowMovesFartherThanTheFarthestThatWasPressed) {
  const SceneDef def = small();
  Moved m(def);
  Random random(9);
  for (int n = 0; n < 30; ++n) m.press(60 + n, static_cast<float>(random.uniform(0.0, 4e-4)));
  double most = 0.0;
  for (int j = 0; j < 200; ++j) most = std::max(most, m.moved(j));
  std::array<double, 200> before;
  for (int j = 0; j < 200; ++j) before[static_cast<std::size_t>(j)] = m.moved(j);
  Propagation propagation(m.clay.stride());
  propagation.drag(*def.propagation, m.clay, WallSide::outside, 0.0);
  for (int j = 0; j < 200; ++j) {
    EXPECT_GE(m.moved(j), before[static_cast<std::size_t>(j)]) << j;
    EXPECT_LE(m.moved(j), most) << j;
  }
}

// The steepest step from row to row, m/m, after a rib's end was pressed into the wall.
double steepest(SceneDef def, bool with) {
  if (!with) def.propagation.reset();
  Scene scene = made(def);
  Hands hands;
  hands.wheel_speed = 18.0;
  for (std::uint8_t n = 0; n < scene.def().tools.size(); ++n)
    if (scene.def().tools[n].name == "flat_rib") hands.hand[0].tool = n + 1;
  hands.hand[0].active = true;
  hands.hand[0].side = SideWish::outside;
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0].position = {0.0575 - 1e-6 * std::min(n, 3000), 0.06, 0};
    scene.step(hands, 0.001);
  }
  double most = 0.0;
  const Clay& clay = scene.clay();
  for (int j = clay.floor_rows(); j + 1 < clay.rows(); ++j)
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i)
      most = std::max(most, std::fabs(double{clay.outer(j + 1)[i] - clay.outer(j)[i]}) /
                                (clay.row_height(j + 1) - clay.row_height(j)));
  return most;
}

TEST(Propagation, ARibsEndLeavesNoRazorEdge) {
  const double sharp = steepest(small(), false);
  const double soft = steepest(small(), true);
  EXPECT_GT(sharp, 0.5);
  EXPECT_LT(soft, 0.5 * sharp);
}

TEST(Propagation, WithVolumeNoClayIsLostWhateverHandsDo) {
  SceneDef def = small();
  def.volume.emplace();
  for (const bool walls : {false, true}) {
    if (walls) def.walls.emplace();
    expect_clay_kept(def, 31, 10000);
  }
}

}  // namespace
}  // namespace onggi::effects::propagation_test
