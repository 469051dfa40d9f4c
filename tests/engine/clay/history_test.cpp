#include "engine/clay/history.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "engine/math/random.h"
#include "tests/support/clay_shape.h"

namespace onggi::clay::history_test {
namespace {

ClayDef small() {
  ClayDef def;
  def.rows = 60;
  def.sectors = 40;
  return def;
}

Clay lump(const ClayDef& def) { return std::move(*Clay::create(def)); }

// One stroke: some rows pressed, then hands clear for half a second.
void stroke(Clay& clay, History& history, Random& random, double seconds = 0.2) {
  const int first = static_cast<int>(random.uniform(0.0, 50.0));
  for (int n = 0; n < static_cast<int>(seconds * 1000.0); ++n) {
    for (int j = first; j < first + 8; ++j) {
      clay.outer_mut(j)[static_cast<std::size_t>(n) % 40] -= 1e-6f;
      clay.mark_dirty(j);
    }
    if (n % 50 == 0) {
      clay.set_row_thickness(first + 3, clay.row_thickness(first + 3) * 0.999);
      clay.restack(first + 3);
    }
    history.follow(clay, History::Stir::touching, 0.001);
  }
  for (int n = 0; n < 500; ++n) history.follow(clay, History::Stir::none, 0.001);
}

void step_back(Clay& clay, History& history) {
  int calls = 0;
  while (!history.step_back_some(clay, 8192)) ASSERT_LT(++calls, 10000);
}

TEST(History, AFreshLumpHasNothingToTakeBack) {
  Clay clay = lump(small());
  History history(clay);
  EXPECT_FALSE(history.can_step_back());
  const auto before = test::exact_shape(clay);
  EXPECT_TRUE(history.step_back_some(clay, 8192));
  for (int n = 0; n < 1000; ++n) history.follow(clay, History::Stir::none, 0.001);
  EXPECT_FALSE(history.can_step_back());
  EXPECT_EQ(test::exact_shape(clay), before);
}

TEST(History, EveryStrokeComesBackBitForBitLastOneFirst) {
  Clay clay = lump(small());
  History history(clay);
  Random random(3);
  std::vector<std::vector<double>> shapes;
  for (int n = 0; n < 12; ++n) {
    shapes.push_back(test::exact_shape(clay));
    stroke(clay, history, random);
  }
  for (int n = 11; n >= 0; --n) {
    ASSERT_TRUE(history.can_step_back()) << n;
    step_back(clay, history);
    EXPECT_EQ(test::exact_shape(clay), shapes[static_cast<std::size_t>(n)]) << n;
  }
  EXPECT_FALSE(history.can_step_back());
}

TEST(History, AStrokeUnderWayIsTakenBackToItsBeginning) {
  Clay clay = lump(small());
  History history(clay);
  Random random(4);
  stroke(clay, history, random);
  const auto before = test::exact_shape(clay);
  for (int n = 0; n < 100; ++n) {
    clay.inner_mut(30)[5] += 1e-5f;
    clay.mark_dirty(30);
    history.follow(clay, History::Stir::touching, 0.001);
  }
  step_back(clay, history);
  EXPECT_EQ(test::exact_shape(clay), before);
  EXPECT_TRUE(history.can_step_back());  // the stroke before it
}

TEST(History, ALongTouchIsCutIntoStepsOfThreeSeconds) {
  Clay clay = lump(small());
  History history(clay);
  Random random(5);
  const auto fresh = test::exact_shape(clay);
  stroke(clay, history, random, 10.0);
  int steps = 0;
  for (; history.can_step_back(); ++steps) step_back(clay, history);
  EXPECT_EQ(steps, 4);
  EXPECT_EQ(test::exact_shape(clay), fresh);
}

// A step's edge is sharp to a few ticks: rows and floor may be of either side of it, together.
TEST(History, AFloorThatGivesWayAsAStepEndsIsSolidJustWhereItsRowsAre) {
  for (int opened = 2980; opened <= 3020; ++opened) {
    Clay clay = lump(small());
    History history(clay);
    const double top = clay.row_height(clay.floor_rows() - 1) - 1e-5;
    for (int n = 0; n < 3200; ++n) {
      for (int j = 0; j < clay.rows(); ++j) {
        clay.outer_mut(j)[static_cast<std::size_t>(n) % 40] -= 1e-7f;
        clay.mark_dirty(j);
      }
      if (n == opened) {
        clay.open_floor_row(0.004);
        clay.lower_floor(top);
      }
      history.follow(clay, History::Stir::touching, 0.001);
    }
    while (history.can_step_back()) {
      step_back(clay, history);
      const int solid = clay.floor_rows();
      for (int j = 0; j < clay.rows(); ++j)
        ASSERT_EQ(clay.inner(j)[0] == 0.0f, j < solid) << "opened at " << opened << ", row " << j;
      EXPECT_GE(clay.floor_top(), clay.row_height(solid - 1));
      EXPECT_LE(clay.floor_top(), clay.row_height(solid));
    }
  }
}

TEST(History, WhatWasTakenBackCanBeThrownAnew) {
  Clay clay = lump(small());
  History history(clay);
  Random random(6);
  stroke(clay, history, random);
  const auto one = test::exact_shape(clay);
  for (int n = 0; n < 5; ++n) {
    stroke(clay, history, random);
    step_back(clay, history);
    EXPECT_EQ(test::exact_shape(clay), one) << n;
  }
}

void settle(Clay& clay, History& history, History::Stir stir, int ticks) {
  for (int t = 0; t < ticks; ++t) {
    for (int j = 0; j < clay.rows(); ++j) clay.outer_mut(j)[0] -= 1e-8f, clay.mark_dirty(j);
    history.follow(clay, stir, 0.001);
  }
}

// Undone clay may sag, or get the height that its volume asks for. If that were a step, undo would
// take it back, it would come again, and nobody could undo more.
TEST(History, WhatSettlesAfterAnUndoIsTakenBackWithTheTouchBefore) {
  for (const auto stir : {History::Stir::none, History::Stir::moving}) {
    Clay clay = lump(small());
    History history(clay);
    Random random(8);
    std::vector<std::vector<double>> shapes;
    for (int n = 0; n < 4; ++n) {
      shapes.push_back(test::exact_shape(clay));
      stroke(clay, history, random);
    }
    for (int n = 3; n >= 0; --n) {
      step_back(clay, history);
      EXPECT_EQ(test::exact_shape(clay), shapes[static_cast<std::size_t>(n)]) << n;
      EXPECT_EQ(history.can_step_back(), n > 0);
      settle(clay, history, stir, 7000);  // more than two steps of the longest
    }
    // A lump that sagged is put up again; heights that came right are nobody's to take back.
    ASSERT_EQ(history.can_step_back(), stir == History::Stir::moving);
    if (stir != History::Stir::moving) continue;
    step_back(clay, history);
    EXPECT_EQ(test::exact_shape(clay), shapes[0]);
    EXPECT_FALSE(history.can_step_back());
  }
}

// The touch's first ticks, too: a cut that began while the clay settled came back smaller.
TEST(History, ATouchWhileUndoneClaySettlesIsTakenBackToTheUndo) {
  for (const int ticks : {1, 300, 5000}) {
    Clay clay = lump(small());
    History history(clay);
    Random random(9);
    const auto fresh = test::exact_shape(clay);
    stroke(clay, history, random);
    step_back(clay, history);
    settle(clay, history, History::Stir::moving, ticks);
    for (int n = 0; n < 200; ++n) {
      for (int j = 0; j < clay.rows(); ++j) clay.outer_mut(j)[3] -= 1e-6f, clay.mark_dirty(j);
      history.follow(clay, History::Stir::touching, 0.001);
    }
    for (int n = 0; n < 500; ++n) history.follow(clay, History::Stir::none, 0.001);
    ASSERT_TRUE(history.can_step_back());
    step_back(clay, history);
    EXPECT_EQ(test::exact_shape(clay), fresh) << ticks;
    EXPECT_FALSE(history.can_step_back());
  }
}

TEST(History, ALumpThatIsRenewedWhileUndoneClaySettlesCanBeTakenBack) {
  Clay clay = lump(small());
  History history(clay);
  Random random(10);
  stroke(clay, history, random);
  const auto thrown = test::exact_shape(clay);
  stroke(clay, history, random);
  step_back(clay, history);
  while (!history.begin_step(clay, 100)) {
  }
  while (!clay.renew_some(8192)) history.follow(clay, History::Stir::moving, 0.001);
  ASSERT_TRUE(history.can_step_back());
  step_back(clay, history);
  EXPECT_EQ(test::exact_shape(clay), thrown);
}

TEST(History, ARenewedLumpIsTakenBackWithItsFloorAndHeights) {
  Clay clay = lump(small());
  History history(clay);
  Random random(7);
  stroke(clay, history, random);
  clay.open_floor_row(0.01);
  clay.lower_floor(clay.row_height(clay.floor_rows()) - 0.0005);
  const auto thrown = test::exact_shape(clay);
  const double rim = clay.rim_height();
  while (!history.begin_step(clay, 100)) {
  }
  bool done = false;
  while (!done) {
    done = clay.renew_some(8192);
    history.follow(clay, History::Stir::touching, 0.001);
  }
  EXPECT_NE(test::exact_shape(clay), thrown);
  step_back(clay, history);
  EXPECT_EQ(test::exact_shape(clay), thrown);
  EXPECT_EQ(clay.rim_height(), rim);
}

TEST(History, KeepsAtLeastHalfAMinuteOfTheBusiestThrowingOnTheDefaultGrid) {
  // The tool runs up and down the whole wall in a second and a half, without a pause.
  Clay clay = lump({});
  History history(clay);
  double time = 0.0;
  for (int n = 0; n < 60000; ++n, time += 0.001) {
    const int middle =
        static_cast<int>(200.0 + 180.0 * ((n / 750) % 2 == 0 ? 1 : -1) * ((n % 750) / 375.0 - 1.0));
    for (int j = middle - 16; j < middle + 16; ++j) {
      clay.pressable_outer(j)[static_cast<std::size_t>(n) % 360] -= 1e-7f;
      clay.mark_dirty(j);
    }
    history.follow(clay, History::Stir::touching, 0.001);
  }
  int steps = 0;
  for (; history.can_step_back(); ++steps) step_back(clay, history);
  EXPECT_GE(steps * History::kLongest, 30.0 - History::kLongest);
  EXPECT_LT(steps, 25);  // and not for ever: the memory is fixed
}

RC_GTEST_PROP(HistoryProperty, ComesBackToAShapeThatWasThereWhateverIsDone, ()) {
  Clay clay = lump(small());
  History history(clay);
  Random random(*rc::gen::arbitrary<std::uint32_t>());
  std::vector<std::vector<double>> shapes{test::exact_shape(clay)};
  for (int n = 0; n < 8; ++n) {
    if (*rc::gen::arbitrary<bool>() || !history.can_step_back()) {
      stroke(clay, history, random, *rc::gen::inRange(1, 300) * 1e-3);
      shapes.push_back(test::exact_shape(clay));
    } else {
      step_back(clay, history);
      shapes.pop_back();
      RC_ASSERT(test::exact_shape(clay) == shapes.back());
    }
  }
}

}  // namespace
}  // namespace onggi::clay::history_test
