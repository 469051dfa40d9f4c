#include "engine/effects/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/clay/row_division.h"
#include "tests/engine/effects/random_hands.h"
#include "tests/support/clay_shape.h"

namespace onggi::effects::refinement_test {
namespace {

using namespace effects_test;

SceneDef studio(int rows = 80, int sectors = 64) {
  SceneDef def;
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.height = 0.13;
  def.clay.inner_radius = 0.036;
  def.clay.wall_min = 0.003;
  def.contact.relaxation_time = 0.02;
  def.moisture->sponge_height = 0.06;
  def.walls.emplace();
  def.propagation.emplace();
  def.smoothing.emplace();
  def.volume.emplace();
  return def;
}

SceneDef everything() {
  SceneDef def = studio();
  def.walls->tear_thickness = 0.0035;
  def.springback.emplace();
  def.wobble.emplace();
  def.slump.emplace();
  return def;
}

double thickest(const Clay& clay) { return *std::ranges::max_element(clay.row_thicknesses()); }

// Two fingers that pull a wall up between them: `gap` is left of it.
void pull(Scene& scene, double gap, double seconds = 4.0) {
  Hands hands;
  hands.wheel_speed = 18.0;
  const ClayDef& def = scene.def().clay;
  const double middle = 0.5 * (def.outer_radius + def.inner_radius);
  const double off = scene.def().tool.radius + 0.5 * gap;
  const int ticks = static_cast<int>(seconds * 1000);
  for (int n = 0; n < ticks; ++n) {
    const double height = 0.02 + (scene.clay().rim_height() - 0.01) * n / ticks;
    hands.hand[0] = {{middle + off, height, 0}, true, SideWish::outside};
    hands.hand[1] = {{middle - off, height, 0}, true, SideWish::inside};
    scene.step(hands, 0.001);
  }
}

void rest(Scene& scene, int ticks, Hands hands = {}) {
  for (int n = 0; n < ticks; ++n, hands.renew = hands.restore = false) scene.step(hands, 0.001);
}

struct Kneaded {
  int most_rows = 0;
};

void knead(SceneDef def, std::uint64_t seed, int ticks, Kneaded& out) {
  Scene scene = made(def);
  const Clay& clay = scene.clay();
  const double whole = clay.volume();
  RandomHands hands(seed);
  for (int n = 0; n < ticks; ++n) {
    scene.step(hands.next(), hands.seconds());
    out.most_rows = std::max(out.most_rows, clay.rows());
    ASSERT_LE(thickest(clay), Volume::kThickest * clay.first_thickness()) << n;
    ASSERT_LE(clay.rim_height(), Volume::kTallest * def.clay.height) << n;
    if (n % 500 != 0) continue;
    ASSERT_NEAR(clay.volume() / whole, 1.0, 2e-9) << n;
    ASSERT_NO_FATAL_FAILURE(expect_whole(clay)) << n;
  }
}

TEST(Refinement, NoRowGetsThickerThanTwoOfTheLumpsWhateverHandsDo) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Kneaded out;
    ASSERT_NO_FATAL_FAILURE(knead(studio(), seed, 30000, out)) << seed;
    EXPECT_GT(out.most_rows, 80) << seed;
  }
}

TEST(Refinement, NorWithEveryEffectOnTheCoarsestGrid) {
  SceneDef def = everything();
  Kneaded out;
  ASSERT_NO_FATAL_FAILURE(knead(def, 4, 20000, out));
  def.clay.sectors = 16;
  ASSERT_NO_FATAL_FAILURE(knead(def, 5, 20000, out));
  EXPECT_GT(out.most_rows, 80);
}

TEST(Refinement, ThreeMinutesOfHandsAtRandomLeaveAPotOfThreeLumpsHeightAtTheMost) {
  Kneaded out;
  ASSERT_NO_FATAL_FAILURE(knead(studio(), 6, 180000, out));
  EXPECT_EQ(out.most_rows, 160) << "all there are";
}

// How hard a finger is pressed back that was pushed 3 mm into a wall with another behind it, in the
// mean of the third second after, N.
double felt(Scene& scene) {
  const Clay& clay = scene.clay();
  const double height = 0.5 * clay.rim_height();
  const int row = clay.first_row_above(height);
  const double far = *std::ranges::max_element(clay.outer(row)) + 0.008;
  const double near = *std::ranges::min_element(clay.inner(row)) - 0.008;
  Hands hands;
  hands.wheel_speed = 18.0;
  double sum = 0.0;
  for (int n = 0; n < 3300; ++n) {
    hands.hand[0] = {{far - std::min(1e-5 * n, 0.003), height, 0}, true, SideWish::outside};
    hands.hand[1] = {{near, height, 0}, true, SideWish::inside};
    const Feedback felt = scene.step(hands, 0.001);
    if (n >= 2300) sum += length(felt.hand[0].force);
  }
  return sum / 1000.0;
}

// Two hands reach more rows there than can be reshaped in a tick.
TEST(Refinement, NorOnTheStudiosOwnGrid) {
  int most = 0;
  for (const std::uint64_t seed : {1u, 2u}) {
    Scene scene = made(studio(600, 512));
    const Clay& clay = scene.clay();
    const double whole = clay.volume();
    RandomHands hands(seed);
    for (int n = 0; n < 60000; ++n) {
      scene.step(hands.next(), 0.001);
      ASSERT_LE(thickest(clay), Volume::kThickest * clay.first_thickness()) << n;
      most = std::max(most, clay.rows());
    }
    rest(scene, 1000);  // rows that a rim carried down wait for their girth
    EXPECT_NEAR(clay.volume() / whole, 1.0, 2e-9) << seed;
  }
  EXPECT_GT(most, 900) << "nobody pulled it up";
}

TEST(Refinement, APotThatMayGetNoTallerHoldsAndAHandFeelsIt) {
  SceneDef def = studio(40, 48);
  def.walls.reset();  // every press thins the wall
  def.friction.reset();
  Scene fresh = made(def);
  const double gives_way = felt(fresh);
  Scene scene = made(def);
  const Clay& clay = scene.clay();
  const double whole = clay.volume();
  double last = 0.0;
  for (int n = 0; n < 60 && clay.rim_height() > last; ++n) {
    last = clay.rim_height();
    pull(scene, std::max(0.002, 0.016 - 0.001 * n), 1.0);
    ASSERT_LE(clay.rim_height(), Volume::kTallest * def.clay.height) << n;
    ASSERT_LE(thickest(clay), Volume::kThickest * clay.first_thickness()) << n;
  }
  EXPECT_GT(clay.rim_height(), 1.5 * def.clay.height);
  EXPECT_GT(clay.rows(), 60);
  EXPECT_NEAR(clay.volume() / whole, 1.0, 2e-9);
  rest(scene, 1000);
  EXPECT_GT(felt(scene), 2.9 * gives_way);
  EXPECT_NEAR(clay.volume() / whole, 1.0, 2e-9);
  expect_whole(clay);
}

TEST(Refinement, TheOnlyThinRowsAreFoundWhereverTheyStand) {
  for (const auto& [rows, pair] : {std::pair{80, 40}, {80, 41}, {81, 40}, {81, 41}, {81, 78}}) {
    ClayDef def;
    def.rows = rows;
    def.sectors = 48;
    Clay clay = std::move(*Clay::create(def, best_vectors(), 5));
    Volume volume(clay);
    Refinement refinement;
    clay::divide_row(clay, pair, volume.of_row(pair));
    volume.row_divided(clay, {pair});
    volume.keep(clay, 0.001);
    int found = 0;
    for (int n = 0; n < 2 * clay.rows(); ++n) {
      const Refinement::Change change = refinement.next(clay, volume);
      if (change.kind != Refinement::Change::Kind::join) continue;
      EXPECT_EQ(change.row, pair);
      ++found;
    }
    EXPECT_GT(found, 0) << "row " << pair << " of " << rows;
  }
}

TEST(Refinement, WhereSpareRowsAreFewThinOnesAreJoinedAndNoMoreThanAreWanted) {
  ClayDef def;
  def.rows = 80;
  def.sectors = 48;
  Clay clay = std::move(*Clay::create(def, best_vectors(), Refinement::spare_rows(def)));
  Volume volume(clay);
  Refinement refinement;
  const double whole = clay.volume();
  using Kind = Refinement::Change::Kind;
  EXPECT_EQ(refinement.next(clay, volume).kind, Kind::none) << "there is nothing to do";
  const auto divide = [&](int j) {
    clay::divide_row(clay, j, volume.of_row(j));
    volume.row_divided(clay, {j});
    volume.keep(clay, 0.001);
  };
  for (int j = 76; j > 0; --j)
    if (clay.spare_rows() > 5 && clay::may_divide(clay, j)) divide(j);
  ASSERT_EQ(clay.spare_rows(), 5);
  // A line that would be lost.
  const int line = 100;
  for (float& r : clay.outer_mut(line)) r -= 0.001f;
  volume.keep(clay, 0.001);
  const auto deep = [&] {
    int rows = 0;
    for (int j = 0; j < clay.rows(); ++j) rows += clay.outer(j)[0] < 0.0545f ? 1 : 0;
    return rows;
  };
  const double lined = clay.volume();
  int joins = 0;
  for (int n = 0; n < 1000; ++n) {
    const Refinement::Change change = refinement.next(clay, volume);
    if (change.kind != Kind::join) continue;
    clay::join_rows(clay, change.row, volume.of_row(change.row) + volume.of_row(change.row + 1));
    volume.rows_joined(clay, {change.row});
    volume.keep(clay, 0.001);
    ++joins;
  }
  EXPECT_EQ(clay.spare_rows(), 10);
  EXPECT_EQ(joins, 5);
  EXPECT_EQ(deep(), 1);
  EXPECT_LE(thickest(clay), Refinement::kJoined * clay.first_thickness());
  EXPECT_NEAR(clay.volume() / lined, 1.0, 1e-9);
  EXPECT_NEAR(clay.volume() / whole, 1.0, 1e-9);
}

TEST(Refinement, APullDividesRowsAndStrokesComeBackToTheBitLastOneFirst) {
  for (const SceneDef& def : {studio(), everything()}) {
    Scene scene = made(def);
    const Clay& clay = scene.clay();
    std::vector<std::vector<double>> shapes;
    std::vector<int> rows;
    Hands restore;
    restore.restore = true;
    for (const double gap : {0.014, 0.010, 0.007, 0.005}) {
      rest(scene, 3000);
      shapes.push_back(test::exact_shape(clay));
      rows.push_back(clay.rows());
      pull(scene, gap, 4.0);
    }
    EXPECT_GT(clay.rows(), 100);
    rest(scene, 3000);
    while (!shapes.empty()) {
      ASSERT_TRUE(scene.can_restore());
      rest(scene, 200, restore);
      if (test::exact_shape(clay) != shapes.back()) continue;
      EXPECT_EQ(clay.rows(), rows.back());
      shapes.pop_back(), rows.pop_back();
    }
    EXPECT_EQ(clay.rows(), def.clay.rows);
  }
}

TEST(Refinement, AFreshLumpHasTheLumpsRowsAndTheOldPotComesBackWithItsOwn) {
  Scene scene = made(everything());
  const Clay& clay = scene.clay();
  for (const double gap : {0.014, 0.009, 0.006}) pull(scene, gap, 4.0);
  rest(scene, 3000);
  const std::vector<double> thrown = test::exact_shape(clay);
  const int rows = clay.rows();
  EXPECT_GT(rows, 85);
  Hands hands;
  hands.renew = true;
  rest(scene, 400, hands);
  EXPECT_EQ(clay.rows(), 80);
  EXPECT_NEAR(clay.rim_height(), 0.13, 1e-12);
  expect_whole(clay);
  hands.renew = false;
  hands.restore = true;
  rest(scene, 400, hands);
  EXPECT_EQ(clay.rows(), rows);
  EXPECT_EQ(test::exact_shape(clay), thrown);
  pull(scene, 0.006, 1.0);
  expect_whole(clay);
}

TEST(Refinement, ComesToTheSameBitsOnAllVectorsAndInEveryRun) {
  std::vector<std::uint64_t> hashes;
  for (const Vectors kind : vectors_here()) {
    Scene scene = made(everything(), kind);
    for (const double gap : {0.008, 0.003}) pull(scene, gap);
    rest(scene, 100);
    EXPECT_GT(scene.clay().rows(), 80);
    hashes.push_back(scene.state_hash());
  }
  for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(Refinement, TheWetBandStaysWhereTheHandWas) {
  Scene scene = made(studio());
  Hands hands;
  hands.water = true;
  hands.hand[0] = {{0.08, 0.10, 0}, true, SideWish::outside};
  for (int n = 0; n < 500; ++n) scene.step(hands, 0.001);
  const auto wetness_at = [&](double height) {
    return scene.wetness_of(
        std::min(scene.clay().first_row_above(height), scene.clay().rows() - 1));
  };
  EXPECT_GT(wetness_at(0.10), 0.2);
  const double dry = wetness_at(0.03);
  hands.water = false;
  hands.wheel_speed = 18.0;
  const double before = wetness_at(0.10);
  // Rows low down divide, and all above them go up.
  const int rows = scene.clay().rows();
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0] = {{0.0615 - 4e-6 * n, 0.03, 0}, true, SideWish::outside};
    hands.hand[1] = {{0.030, 0.03, 0}, true, SideWish::inside};
    scene.step(hands, 0.001);
  }
  const double risen = scene.clay().rim_height() - 0.13;
  EXPECT_GT(scene.clay().rows(), rows + 3);
  EXPECT_NEAR(wetness_at(0.10 + risen), before * std::exp(-3.0 / 60.0), 0.02);
  EXPECT_LT(wetness_at(0.03), dry + 0.02);
}

TEST(Refinement, AViewOfAPotWhoseRowsDividedIsThatPot) {
  Scene scene = made(studio());
  const Clay& clay = scene.clay();
  ClayView view;
  view.lay(scene.def().clay, clay.room());
  for (const double gap : {0.008, 0.003}) pull(scene, gap);
  ASSERT_GT(clay.rows(), 80);
  for (int j = scene.take_dirty_row(0); j >= 0; j = scene.take_dirty_row(0)) {
    view.place(j, clay::place_of(clay, j));
    view.shape(j, clay.outer(j), clay.inner(j));
  }
  for (int j = scene.take_moved_row(0); j >= 0; j = scene.take_moved_row(0))
    view.place(j, clay::place_of(clay, j));
  EXPECT_EQ(view.rows(), clay.rows());
  const Profile seen = view.profile();
  const Profile is = clay.profile();
  ASSERT_EQ(seen.points.size(), is.points.size());
  for (std::size_t n = 0; n < is.points.size(); ++n) {
    EXPECT_EQ(seen.points[n].height, is.points[n].height) << n;
    EXPECT_EQ(seen.points[n].outer, is.points[n].outer) << n;
  }
}

}  // namespace
}  // namespace onggi::effects::refinement_test
