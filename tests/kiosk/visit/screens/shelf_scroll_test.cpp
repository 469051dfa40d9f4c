#include "kiosk/visit/screens/shelf_scroll.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::screens::shelf_scroll_test {
namespace {

ShelfScroll shelf(int columns = 12, int shown = 4) {
  ShelfScroll s;
  s.bound(columns, shown);
  return s;
}

void rest(ShelfScroll& s) {
  for (int i = 0; i < 120; ++i) s.update(1.0 / 30, false);
}

TEST(ShelfScroll, GoesWhereTheFingerGoesAndRestsOnAWholeColumn) {
  ShelfScroll s = shelf();
  s.hold();
  s.drag(1.7);
  s.update(0.1, false);
  EXPECT_DOUBLE_EQ(s.at(), 1.7);
  s.release(0);
  rest(s);
  EXPECT_EQ(s.at(), 2);
  EXPECT_FALSE(s.moving());
}

TEST(ShelfScroll, RunsOnTheFasterItWasLetGo) {
  double before = 0;
  for (const double speed : {0.0, 4.0, 10.0, 20.0}) {
    ShelfScroll s = shelf();
    s.hold();
    s.drag(1);
    s.release(speed);
    rest(s);
    EXPECT_GT(s.at(), before);
    before = s.at();
  }
}

TEST(ShelfScroll, AShortFlickTurnsItByOneEitherWay) {
  for (const double way : {1.0, -1.0}) {
    ShelfScroll s = shelf();
    s.show(7);  // the fifth column in front
    const double from = s.at();
    s.hold();
    s.drag(0.1 * way);
    s.release(1.2 * way);
    rest(s);
    EXPECT_EQ(s.at(), from + way);
  }
}

TEST(ShelfScroll, NeverRestsBeyondItsEndsHoweverItIsThrown) {
  for (int seed = 0; seed < 500; ++seed) {
    ShelfScroll s = shelf(1 + seed % 17, 1 + seed % 5);
    s.hold();
    s.drag(7 * std::sin(seed));
    s.release(40 * std::cos(3.0 * seed));
    rest(s);
    EXPECT_GE(s.at(), 0);
    EXPECT_LE(s.at(), std::max(0, s.columns() - s.shown()));
    EXPECT_EQ(s.at(), std::round(s.at()));
  }
}

TEST(ShelfScroll, BeyondItsEndItGoesAThirdAsFar) {
  ShelfScroll s = shelf();
  s.hold();
  s.drag(-0.3);
  const double at = s.at();
  s.drag(-0.3);
  EXPECT_NEAR(at - s.at(), 0.1, 1e-12);
}

TEST(ShelfScroll, MovesWithoutAJumpAndIsThereAtOnceWithLessMotion) {
  ShelfScroll s = shelf();
  s.step(4);
  double last = s.at();
  for (int i = 0; i < 60; ++i) {
    s.update(1.0 / 60, false);
    EXPECT_GE(s.at(), last);
    EXPECT_LT(s.at() - last, 0.5);
    last = s.at();
  }
  s.step(-4);
  s.update(1.0 / 60, true);
  EXPECT_EQ(s.at(), 0);
}

TEST(ShelfScroll, WhatIsAskedForIsAmongWhatIsShownAndNothingMovesForWhatIs) {
  ShelfScroll s = shelf();
  for (const int column : {3, 11, 6, 0}) {
    s.show(column);
    EXPECT_GE(column, s.first());
    EXPECT_LT(column, s.first() + s.shown());
  }
  s.show(3);
  EXPECT_EQ(s.first(), 0);
}

TEST(ShelfScroll, AShelfThatGrowsStaysWhereItIs) {
  ShelfScroll s = shelf(6, 4);
  s.step(2);
  rest(s);
  s.bound(9, 4);
  EXPECT_EQ(s.at(), 2);
  s.bound(3, 4);
  EXPECT_EQ(s.at(), 0);
}

}  // namespace
}  // namespace onggi::screens::shelf_scroll_test
