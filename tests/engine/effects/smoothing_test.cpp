#include "engine/effects/smoothing.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/random.h"
#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::smoothing_test {
namespace {

using namespace effects_test;

// A wall with lines of 10 mm, a millimetre deep or so, that a rib lies against all round.
struct Lined {
  Clay clay;
  explicit Lined(double depth = 0.001, double inner = 0.022) : clay(lump(inner)) {
    clay.keep_areas();
    clay.keep_displacements();
    for (int j = 0; j < clay.rows(); ++j) {
      const double line = portable::sin(2.0 * portable::kPi * clay.row_height(j) / 0.01);
      for (float& r : clay.outer_mut(j)) r = static_cast<float>(0.055 - depth * (1.0 + line));
      clay.areas()->set(j, clay.measured_area(j));
    }
  }
  static Clay lump(double inner) {
    ClayDef def;
    def.rows = 200;
    def.sectors = 24;
    def.inner_radius = inner;
    def.floor_thickness = 0.0;
    return std::move(*Clay::create(def));
  }
  void rib(const SmoothingDef& def, double seconds) {
    press(0, 24);
    Smoothing smoothing(clay.rows());
    smoothing.even(def, clay, WallSide::outside, 0.05, 0.15, seconds);
    clay.displacements(false)->clear(clay.stored());
  }
  // Sectors [from, to) have moved in all rows.
  void press(int from, int to) {
    for (int j = 0; j < clay.rows(); ++j) {
      clay.displacements(false)->mark(j, {0, 3});
      std::fill_n(clay.displacements(false)->row(clay.stored(j)) + from, to - from, 1e-6f);
    }
  }
  double largest(double from = 0.05, double to = 0.15) const {
    double r = 0.0;
    for (int j = clay.first_row_above(from); j < clay.first_row_above(to); ++j)
      r = std::max(r, double{clay.outer(j)[3]});
    return r;
  }
  double least() const {
    double r = 1.0;
    for (int j = clay.first_row_above(0.05); j < clay.first_row_above(0.15); ++j)
      r = std::min(r, double{clay.outer(j)[3]});
    return r;
  }
};

TEST(Smoothing, LinesFadeAtTheRateOfDiffusion) {
  Lined wall(0.0001);
  const SmoothingDef def;
  const double before = wall.largest(0.08, 0.12) - 0.0549;
  for (int n = 0; n < 200; ++n) wall.rib(def, 1e-4);
  const double rate = std::pow(2.0 * portable::kPi / 0.01, 2) * def.pace;  // a second
  const double after = wall.largest(0.08, 0.12) - 0.0549;
  EXPECT_NEAR(after / before, std::exp(-rate * 0.02), 0.02);
}

RC_GTEST_PROP(SmoothingProperty, AnyTickIsStableAndNothingGetsLargerOrSmallerThanItWas, ()) {
  Lined wall(*rc::gen::inRange(1, 100) * 1e-5);
  SmoothingDef def;
  def.pace = std::pow(10.0, *rc::gen::inRange(-60, -19) * 0.1);
  const double most = wall.largest();
  const double least = wall.least();
  const double clay = wall.clay.volume();
  for (const double seconds : {1e-6, 0.005, 10.0, 0.001}) {
    wall.rib(def, seconds);
    RC_ASSERT(wall.largest() <= most);
    RC_ASSERT(wall.least() >= least);
  }
  RC_ASSERT(std::fabs(wall.clay.volume() / clay - 1.0) < 1e-7);
}

TEST(Smoothing, TheWallNeverGetsThinnerThanItMay) {
  Lined wall(0.001, 0.0488);  // the grooves are at wall_min
  const SmoothingDef def{1e-2};
  for (int n = 0; n < 20; ++n) wall.rib(def, 0.005);
  for (int j = 0; j < wall.clay.rows(); ++j)
    for (std::size_t i = 0; i < 24; ++i)
      ASSERT_GE(wall.clay.outer(j)[i] - wall.clay.inner(j)[i], 0.004f - 1e-7f);
}

// How uneven the wall is between two heights: the largest outer radius less the least, m.
double unevenness(const Clay& clay) {
  const Profile p = clay.profile();
  double least = 1.0;
  double most = 0.0;
  for (double h = 0.085; h < 0.115; h += 0.0005) {
    least = std::min(least, p.outer_at(h));
    most = std::max(most, p.outer_at(h));
  }
  return most - least;
}

SceneDef thrown() {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 64;
  def.volume.emplace();
  def.smoothing.emplace();
  return def;
}

// Lines drawn with a fingertip, and then a tool held against the wall for three turns.
double after_tool(const char* tool) {
  SceneDef def = thrown();
  def.tool.radius = 0.003;
  Scene scene = made(def);
  const double clay = scene.clay().volume();
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0] = {{}, true, SideWish::outside};
  for (int n = 0; n < 9000; ++n) {
    const double height = 0.08 + 0.04 * n / 9000.0;
    const double line = portable::sin(2.0 * portable::kPi * height / 0.01);
    hands.hand[0].position = {0.0572 + 0.0004 * line, height, 0};
    scene.step(hands, 0.001);
  }
  hands.hand[0].active = false;
  scene.step(hands, 0.001);
  for (std::uint8_t n = 0; n < scene.def().tools.size(); ++n)
    if (scene.def().tools[n].name == tool) hands.hand[0].tool = n + 1;
  hands.hand[0].active = true;
  const ToolShape& shape = *find_tool_shape(tool);
  const double off = shape.round() ? shape.usual.radius : 0.5 * shape.usual.thickness;
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0].position = {0.0549 + off + 1e-3 * std::max(0.0, 1.0 - n / 500.0), 0.1, 0};
    scene.step(hands, 0.001);
  }
  EXPECT_NEAR(scene.clay().volume() / clay, 1.0, 2e-9);
  EXPECT_NO_FATAL_FAILURE(expect_whole(scene.clay()));
  return unevenness(scene.clay());
}

// Squares of radii are traded: of 0.2 m and of 0.1 mm in one column they differ by four million.
TEST(Smoothing, AHoleAtItsLeastGetsNoSmallerBesideARowThatIsFarOut) {
  ClayDef def;
  def.rows = 40;
  def.sectors = 24;
  def.inner_radius = 0.0001;
  def.radius_min = 0.0001;
  def.radius_max = 1.0;
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  clay.keep_areas();
  clay.keep_displacements();
  Random random(7);
  Smoothing smoothing(clay.rows());
  for (int n = 0; n < 300; ++n) {
    const double seconds = std::pow(10.0, random.uniform(-7.0, -2.0));
    for (int j = 0; j < clay.rows(); ++j) {
      for (float& r : clay.outer_mut(j)) r = 0.3f;
      for (float& r : clay.inner_mut(j))
        r = random.uniform(0.0, 1.0) < 0.7 ? 0.0001f
                                           : static_cast<float>(random.uniform(0.0, 0.24));
      for (float& r : clay.inner_mut(j)) r = std::max(r, 0.0001f);
      clay.areas()->set(j, clay.measured_area(j));
      clay.displacements(true)->mark(j, {0, 3});
      std::fill_n(clay.displacements(true)->row(clay.stored(j)), 24, 1e-6f);
    }
    smoothing.even({}, clay, WallSide::inside, 0.0, 0.2, seconds);
    clay.displacements(true)->clear(clay.stored());
    for (int j = 0; j < clay.rows(); ++j)
      for (const float r : clay.inner(j)) ASSERT_GE(r, 0.0001f) << "row " << j << ", time " << n;
  }
}

TEST(Smoothing, ARibEvensTheLinesThatAFingerLeft) {
  SceneDef without = thrown();
  const double lines = after_tool("fingertip");  // which smooths nothing
  EXPECT_LT(after_tool("flat_rib"), 0.6 * lines);
}

TEST(Smoothing, WithVolumeNoClayIsLostWhateverARibDoes) {
  SceneDef def = thrown();
  def.walls.emplace();
  expect_clay_kept(def, 51, 20000, "sponge");
}

// What a row reaches to is what hands look for it by: a hollow that fills reaches farther than it
// did.
TEST(Smoothing, EveryRowsExtentHoldsItAsItsLinesFade) {
  Lined wall;
  for (int j = 0; j < wall.clay.rows(); ++j)
    wall.clay.set_extent(j, std::ranges::max(wall.clay.outer(j)),
                         std::ranges::min(wall.clay.inner(j)));
  const double hollow = wall.least();
  for (int n = 0; n < 20; ++n) {
    wall.rib({}, 0.001);
    for (int j = 0; j < wall.clay.rows(); ++j)
      ASSERT_GE(wall.clay.outer_most(j), std::ranges::max(wall.clay.outer(j))) << "row " << j;
  }
  EXPECT_GT(wall.least(), hollow + 1e-5);
}

// Contact marks blocks of eight sectors. On a coarse grid eight are a good part of the pot.
TEST(Smoothing, OnlySectorsThatTheRibMovedAreEvened) {
  Lined wall;
  const Clay before = wall.clay;
  wall.press(5, 14);
  Smoothing(wall.clay.rows()).even({}, wall.clay, WallSide::outside, 0.05, 0.15, 0.01);
  double most = 0.0;
  for (int j = 0; j < wall.clay.rows(); ++j)
    for (std::size_t i = 0; i < 24; ++i) {
      const float moved = std::fabs(wall.clay.outer(j)[i] - before.outer(j)[i]);
      if (i < 5 || i >= 14) {
        ASSERT_EQ(moved, 0.0f) << "row " << j << ", sector " << i;
      } else {
        most = std::max(most, double{moved});
      }
    }
  EXPECT_GT(most, 1e-4);
}

// A quarter turn is 50 sectors here, which is no whole number of blocks.
TEST(Smoothing, APotMadeAQuarterTurnOnIsTheSamePotTurned) {
  SceneDef def = thrown();
  def.clay.sectors = 200;
  def.tool.radius = 0.003;
  Scene one = made(def);
  Scene other = made(def);
  std::uint8_t rib = 0;
  for (std::uint8_t k = 0; k < one.def().tools.size(); ++k)
    if (one.def().tools[k].name == "flat_rib") rib = k + 1;
  const auto step = [&](double r, double height, std::uint8_t tool, double wheel) {
    Hands hands;
    hands.wheel_speed = wheel;
    hands.hand[0] = {{r, height, 0}, true, SideWish::outside};
    hands.hand[0].tool = tool;
    one.step(hands, 0.001);
    hands.hand[0].position = {0, height, r};
    other.step(hands, 0.001);
  };
  for (int n = 0; n < 3000; ++n) {
    const double height = 0.08 + 0.04 * n / 3000.0;
    step(0.0572 + 0.0004 * portable::sin(2.0 * portable::kPi * height / 0.01), height, 0, 18.0);
  }
  const double off = 0.5 * find_tool_shape("flat_rib")->usual.thickness;
  for (int n = 0; n < 1000; ++n) step(0.0552 + off - 1e-6 * n, 0.1, rib, 0.0);
  double apart = 0.0;
  for (int j = 0; j < one.clay().rows(); ++j)
    for (std::size_t i = 0; i < 200; ++i)
      apart = std::max(apart, std::fabs(double{one.clay().outer(j)[i]} -
                                        double{other.clay().outer(j)[(i + 50) % 200]}));
  EXPECT_LT(apart, 1e-5);
}

// Rows that are told as changed are drawn anew, and looked at by other effects: rest must be rest.
TEST(Smoothing, ARibOnAWallThatIsEvenChangesNothingAndTellsNobody) {
  Lined wall(0.0);
  while (wall.clay.take_dirty() >= 0) {
  }
  const std::uint64_t before = wall.clay.hash();
  for (int n = 0; n < 20; ++n) wall.rib({}, 0.001);
  EXPECT_EQ(wall.clay.take_dirty(), -1);
  EXPECT_EQ(wall.clay.hash(), before);
}

}  // namespace
}  // namespace onggi::effects::smoothing_test
