#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/effects/effect_list.h"
#include "engine/effects/slump.h"
#include "engine/effects/springback.h"
#include "engine/effects/tearing.h"
#include "engine/effects/wobble.h"

// What is shared out over ticks is late by a bounded time, on the coarsest grid and on the finest:
// the table of engine/docs/effects.md.
namespace onggi::effects::late_test {
namespace {

struct Grid {
  int rows, sectors;
};
constexpr Grid kGrids[] = {{8, 16}, {6400, 2880}};

ClayDef clay_of(Grid grid) {
  ClayDef def;
  def.rows = grid.rows;
  def.sectors = grid.sectors;
  def.floor_thickness = 0.0;
  def.inner_radius = 0.045;
  def.keep_undo = false;
  return def;
}

double elements(const Clay& clay) { return 1.0 * clay.rows() * clay.stride(); }

// Ticks until `tick` changes no row any more, s; `quiet` seconds without a change are the end.
template <class Tick>
double seconds_of_change(Clay& clay, double dt, double quiet, const Tick& tick) {
  while (clay.take_dirty() >= 0) {
  }
  double last = 0.0;
  for (double t = dt; t < last + quiet; t += dt) {
    tick();
    for (bool any = false; clay.take_dirty() >= 0; any = true)
      if (!any) last = t;
  }
  return last;
}

TEST(Late, APressHasCentredEveryRingNearItWithinTwoRoundsAndTwentyMilliseconds) {
  for (const Grid grid : kGrids)
    for (const double dt : {0.001, 0.005}) {
      Clay clay = std::move(*Clay::create(clay_of(grid)));
      WobbleDef def;
      def.reach = 0.05;
      for (int j = 0; j < clay.rows(); ++j) lay_off_centre(clay, j, {0.004, 0.0});
      Wobble wobble;
      const double round = Round::lasting(0.02, 0.5 * elements(clay));
      ASSERT_LE(round, grid.rows == 8 ? 0.02 : 0.0705);
      // Three presses, the last as the first one's round goes on.
      int n = 0;
      const double last = seconds_of_change(clay, dt, 0.3, [&] {
        if (n++ < 3) wobble.press(0, {{0.07, 0.1, 0.0}, 1.0, WallSide::outside}, dt);
        wobble.centre(def, clay, dt);
      });
      EXPECT_GT(last, 0.0);
      EXPECT_LE(last, 3 * dt + 0.02 + 2.0 * round + dt) << grid.rows << ' ' << dt;
      for (int j = 0; j < clay.rows(); ++j)
        if (std::fabs(clay.row_height(j) - 0.1) < 0.04) {
          ASSERT_LT(off_centre_of(clay, j).x, 0.00395) << j;
        }
    }
}

TEST(Late, AStressHasSunkItsRowWithinTwoRounds) {
  for (const Grid grid : kGrids)
    for (const double dt : {0.001, 0.005}) {
      ClayDef lump = clay_of(grid);
      lump.height = 0.6;
      Clay clay = std::move(*Clay::create(lump));
      Volume volume(clay);
      SlumpDef def;
      def.yield_stress = 5000.0;
      Slump slump(clay.rows());
      Slump::Around around;
      around.seconds = dt;
      const double round = 0.025 + Round::lasting(0.025, elements(clay));
      ASSERT_LE(round, grid.rows == 8 ? 0.05 : 0.166);
      const double before = double{clay.outer(0)[0]};
      double t = 0.0;
      while (double{clay.outer(0)[0]} == before && t < 1.0) {
        slump.sink(def, clay, volume, around);
        t += dt;
      }
      // The foot is the first of the sweep up, so it may only wait for the sweep down.
      EXPECT_LE(t, 0.025 + (round - 0.025) / grid.rows + 2 * dt) << grid.rows << ' ' << dt;
      const int top = clay.first_row_above(0.1) - 1;  // carries half a metre: it yields
      while (clay.row_thickness(top) == lump.height / lump.rows && t < 1.0) {
        slump.sink(def, clay, volume, around);
        volume.keep(clay, dt);
        t += dt;
      }
      EXPECT_LE(t, 2.0 * round) << grid.rows << ' ' << dt;
    }
}

TEST(Late, ARowThatComesBackHasItsTurnWithinASixteenthOfItsTimeOrWhatItsElementsTake) {
  for (const Grid grid : kGrids)
    for (const double dt : {0.001, 0.005}) {
      Clay clay = std::move(*Clay::create(clay_of(grid)));
      clay.keep_areas();
      clay.keep_displacements();
      Springback springback(clay);
      const SpringbackDef def;
      // A band of 2 cm was pressed 1 mm deep.
      const int first = clay.first_row_above(0.08);
      const int end = std::max(clay.first_row_above(0.10), first + 1);
      Displacements& moved = *clay.displacements(false);
      for (int j = first; j < end; ++j) {
        std::fill_n(moved.row(j), clay.stride(), 0.001f);
        moved.mark(j, {0, clay.stride() / Displacements::kBlock});
      }
      springback.load(def, clay, WallSide::outside);
      const double round = Round::lasting(def.time / 16.0, 1.0 * (end - first) * clay.stride());
      std::vector<float> before;
      for (int j = first; j < end; ++j) before.push_back(clay.outer(j)[0]);
      double t = 0.0;
      for (int waiting = end - first; waiting > 0 && t < 1.0;) {
        springback.come_back(def, clay, dt, 0.0);
        t += dt;
        waiting = 0;
        for (int j = first; j < end; ++j)
          waiting += clay.outer(j)[0] == before[static_cast<std::size_t>(j - first)];
      }
      EXPECT_LE(t, round + dt) << grid.rows << ' ' << dt;
    }
}

TEST(Late, ARingThatIsTooThinIsLookedAtWithinATenthOfASecond) {
  for (const Grid grid : kGrids)
    for (const double dt : {0.001, 0.005}) {
      Clay clay = std::move(*Clay::create(clay_of(grid)));
      clay.keep_areas();
      Effects def;
      def.walls.emplace().tear_thickness = 0.011;  // every ring of the lump
      RowTick tick;
      tick.seconds = dt;
      Tearing tearing(clay);
      tearing.lay(clay, 0);
      for (int j = 0; j < clay.rows(); ++j) clay.areas()->mark(j);
      double t = 0.0;
      for (bool all = false; !all && t < 1.0; t += dt) {
        tearing.run({def, clay, tick});
        all = true;
        for (int j = 0; j < clay.rows(); ++j) all = all && clay.areas()->torn(j);
      }
      EXPECT_LE(t, 0.1 + 2 * dt) << grid.rows << ' ' << dt;
    }
}

TEST(Late, ARowThatWasPressedDownHasItsGirthWithinATenthOfASecond) {
  for (const Grid grid : kGrids)
    for (const double dt : {0.001, 0.005}) {
      Clay clay = std::move(*Clay::create(clay_of(grid)));
      Volume volume(clay);
      const double all = clay.volume();
      for (int j = clay.rows() / 2; j < clay.rows(); ++j)
        clay.set_row_thickness(j, 0.95 * clay.row_thickness(j));
      clay.restack(clay.rows() / 2);
      double t = 0.0;
      while (std::fabs(clay.volume() / all - 1.0) > 1e-6 && t < 1.0) {
        // The whole clay's volume is slow to measure on the finest grid.
        for (int n = 0; n < 10; ++n, t += dt) volume.keep(clay, dt);
      }
      EXPECT_LE(t, 0.1 + 10 * dt) << grid.rows << ' ' << dt;
    }
}

TEST(Late, RoundsGoByTheClockWhateverTheTick) {
  for (const double dt : {0.0003, 0.001, 0.0025, 0.005}) {
    Round round;
    round.begin();
    double t = 0.0;
    int last = 0;
    while (!round.over()) {
      double left = dt;
      const int till = round.go_on(left, 0.05, 1000);
      t += dt - left;
      EXPECT_GE(till, last);
      EXPECT_NEAR(till, 1000.0 * t / 0.05, round.over() ? 0.01 : 500.0 * dt / 0.05 + 1.0);
      last = till;
    }
    EXPECT_NEAR(t, 0.05, 1e-9);
    EXPECT_EQ(last, 1000);
  }
}

}  // namespace
}  // namespace onggi::effects::late_test
