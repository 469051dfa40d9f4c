#include "engine/contact/paper_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/contact/tool_contact.h"
#include "engine/math/random.h"
#include "tests/engine/contact/papers_pot.h"
#include "tests/support/sphere.h"

// What goes wrong with the equations as printed, each with the corrected model's answer beside it.
// Numbers are those of the table in engine/docs/paper.md.
namespace onggi::paper_test {
namespace {

using namespace papers_pot;

constexpr Yielding kClay{kTau, 5e6};
constexpr PaperCoefficients kPrinted{10.0, 0.864, 200.0};
constexpr double kMiddle = 0.036 + 0.00009;  // a row's height, half way up the paper's pot

PaperTouch printed(Clay& clay, WallSide mode, Vec3 at, double radius = kRadius,
                   const PaperCoefficients& c = kPrinted, double angle = 0.0, double turn = 0.0) {
  return PaperModel(clay).tick(clay, mode, at, radius, angle, turn, c);
}
Press corrected(Clay& clay, WallSide side, Vec3 at, double radius = kRadius,
                double seconds = 0.001) {
  return press_sphere(clay, side, at, radius, seconds, kClay);
}

int moved_in_row(const Clay& clay, int j) {
  const auto was = static_cast<float>(clay.def().outer_radius);
  return static_cast<int>(std::ranges::count_if(clay.outer(j), [&](float r) { return r != was; }));
}
int moved_rows(const Clay& clay) {
  int rows = 0;
  for (int j = 0; j < clay.rows(); ++j) rows += moved_in_row(clay, j) > 0;
  return rows;
}

TEST(Paper01, TheArcCosineKnowsOnlyHalfThePot) {
  const Vec3 near_side{0.02, kMiddle, 0.05};
  const Vec3 far_side{0.02, kMiddle, -0.05};
  Clay a = made(sheet());
  Clay b = made(sheet());
  EXPECT_GT(printed(a, WallSide::outside, near_side).touched, 100);
  EXPECT_EQ(printed(b, WallSide::outside, far_side).touched, 0);  // pressed as deep, felt nowhere
  const Press near = corrected(a = made(sheet()), WallSide::outside, near_side);
  const Press far = corrected(b = made(sheet()), WallSide::outside, far_side);
  EXPECT_NEAR(near.normal, far.normal, 1e-4 * near.normal);
}

TEST(Paper02, TheWindowLeavesOutElementsThatTheSphereTouches) {
  const Vec3 at{0.0556, kMiddle, 0.0};  // H_r / d = 0.9
  Clay a = made(sheet(0.055));
  Clay b = made(sheet(0.055));
  printed(a, WallSide::outside, at, 0.05);
  corrected(b, WallSide::outside, at, 0.05);
  const int row = a.first_row_above(kMiddle - 1e-6);
  EXPECT_NEAR(moved_in_row(a, row), 2 * 0.9 * 180 / 3.14159, 2);
  EXPECT_NEAR(moved_in_row(b, row), 2 * std::asin(0.9) * 180 / 3.14159, 2);
}

TEST(Paper04, PastTheAxisADistanceHasNoSignAndTheClayIsNotTouched) {
  // A pin of clay 2 mm thick, all of it within the sphere.
  const Vec3 at{0.003, kMiddle, 0.0};
  Clay a = made(sheet(0.002));
  Clay b = made(sheet(0.002));
  const int row = a.first_row_above(kMiddle - 1e-6);
  printed(a, WallSide::outside, at);
  corrected(b, WallSide::outside, at);
  EXPECT_EQ(a.outer(row)[0], 0.002f);
  EXPECT_LT(b.outer(row)[0], 0.002f);
}

TEST(Paper05, LineCollisionComparesAFlatRadiusWithADistanceInSpace) {
  // r < |dy| beyond 0.707 H_r: rows there never collide, however deep they lie.
  const Vec3 at{0.049, kMiddle, 0.0};
  Clay a = made(sheet());
  Clay b = made(sheet());
  printed(a, WallSide::outside, at);
  corrected(b, WallSide::outside, at);
  const double all = 2.0 * kRadius / 0.00018;
  EXPECT_LT(moved_rows(a), 0.72 * all);
  EXPECT_GT(moved_rows(b), 0.97 * all);
}

TEST(Paper06, TheForceFallsManyTimesWhereTheCentreCrossesTheSurface) {
  const auto radial = [](double depth, bool as_printed) {
    Clay clay = made(sheet());
    const Vec3 at{0.05 + kRadius - depth, kMiddle, 0.0};
    return as_printed ? printed(clay, WallSide::outside, at).resistance.x
                      : corrected(clay, WallSide::outside, at).force.x;
  };
  EXPECT_GT(radial(0.0079, true) / radial(0.0081, true), 15.0);
  EXPECT_NEAR(radial(0.0079, false) / radial(0.0081, false), 1.0, 0.1);
}

TEST(Paper07, TheModeChattersWhileAToolTremblesAtTheSurface) {
  Clay a = made(sheet());
  Clay b = made(sheet());
  Random random(7);
  ToolContact contact;
  int changes[2] = {0, 0};
  WallSide last = WallSide::outside;
  Vec3 from{0.0581, kMiddle, 0.0};
  for (int n = 0; n < 600; ++n) {
    const double x = std::max(0.0581 - 2e-5 * n, 0.05);
    const Vec3 at{x + random.uniform(-55e-6, 55e-6), kMiddle, 0.0};
    const WallSide mode = PaperModel::mode(a, at, 0.0, SideWish::by_position);
    changes[0] += mode != last;
    last = mode;
    const WallSide before = contact.side();
    contact.begin_tick();
    contact.step(b, sweep_sphere(from, at, kRadius), 0, 1, kClay);
    changes[1] += contact.side() != before;
    from = at;
  }
  EXPECT_GT(changes[0], 20);
  EXPECT_EQ(changes[1], 0);
}

TEST(Paper13, TheForceGrowsWithTheNumberOfElements) {
  double least[2] = {1e9, 1e9};
  double most[2] = {0, 0};
  for (const auto& [rows, sectors] : {std::pair{200, 180}, {200, 360}, {400, 360}, {800, 360}}) {
    const Vec3 at{0.056, 0.036, 0.0};
    ClayDef def = sheet();
    def.rows = rows;
    def.sectors = sectors;
    Clay a = made(def);
    Clay b = made(def);
    const double force[2] = {printed(a, WallSide::outside, at).resistance.x,
                             corrected(b, WallSide::outside, at).force.x};
    for (int model : {0, 1}) {
      least[model] = std::min(least[model], force[model]);
      most[model] = std::max(most[model], force[model]);
    }
  }
  EXPECT_NEAR(most[0] / least[0], 8.0, 0.3);
  EXPECT_LT(most[1] / least[1], 1.04);
}

TEST(Paper16, AFastWheelCarriesElementsPastTheToolUntouched) {
  // A light touch of a needle's breadth at 300 rpm: 1.8 sectors a tick.
  constexpr double kNeedle = 0.001;
  const Vec3 at{0.05 + kNeedle - 5e-5, kMiddle, 0.0};
  const double turn = 31.4159265 * 0.001;
  Clay a = made(sheet());
  Clay b = made(sheet());
  ToolContact contact;
  for (int n = 0; n < 200; ++n) {
    printed(a, WallSide::outside, at, kNeedle, kPrinted, n * turn, turn);
    const ToolSweep sweep = sweep_sphere(at, at, kNeedle, n * turn, turn);
    const int steps = steps_for(sweep, kClay.relaxation_time, contact.pressed());
    contact.begin_tick();
    for (int step = 0; step < steps; ++step) contact.step(b, sweep, step, steps, kClay);
  }
  const int row = a.first_row_above(kMiddle - 1e-6);
  EXPECT_LT(moved_in_row(a, row), 300);
  EXPECT_GE(moved_in_row(b, row), 359);  // the last turn's end may lie on an edge
}

TEST(Paper17, AFastToolTunnelsTheWall) {
  Clay a = made(ClayDef{});
  Clay b = made(ClayDef{});
  ToolContact contact;
  const double y = a.row_height(200);
  const Vec3 before{0.07, y, 0.0};
  const Vec3 after{0.04, y, 0.0};
  for (Vec3 at : {before, after}) {
    const WallSide mode = PaperModel::mode(a, at, 0.0, SideWish::by_position);
    EXPECT_EQ(printed(a, mode, at).touched, 0);
  }
  const ToolSweep arrive = sweep_sphere(before, before, kRadius);
  const ToolSweep rush = sweep_sphere(before, after, kRadius);
  contact.step(b, arrive, 0, 1, kClay);
  const int steps = steps_for(rush, kClay.relaxation_time, contact.pressed());
  for (int n = 0; n < steps; ++n) contact.step(b, rush, n, steps, kClay);
  EXPECT_GT(contact.reaction().touched, 0);
  EXPECT_EQ(contact.side(), WallSide::outside);
}

TEST(Paper18, AWallOfOneRadiusHasNoThickness) {
  // A fingertip 6 mm into the inner face: the sheet is at the outer face, 27 mm away.
  const Vec3 at{0.020, 0.1, 0.0};
  Clay a = made(ClayDef{});
  Clay b = made(ClayDef{});
  EXPECT_EQ(printed(a, WallSide::inside, at).touched, 0);
  EXPECT_GT(corrected(b, WallSide::inside, at).touched, 0);
}

TEST(Paper22, OneSampleOnTheAxisOrNotANumberSilencesTheHandForGood) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (Vec3 bad : {Vec3{0.0, kMiddle, 0.0}, Vec3{nan, kMiddle, 0.0}}) {
    Clay a = made(sheet());
    PaperFilter filter;
    filter.filter(printed(a, WallSide::outside, bad).force);
    Vec3 out;
    for (int n = 0; n < 5000; ++n) out = filter.filter({0.0, 0.0, 0.0});
    EXPECT_FALSE(is_finite(out));
    filter.settle();
    EXPECT_TRUE(is_finite(filter.filter({0.0, 0.0, 0.0})));
  }
  Clay b = made(sheet());
  EXPECT_TRUE(is_finite(corrected(b, WallSide::inside, {0.0, kMiddle, 0.0}).force));
}

}  // namespace
}  // namespace onggi::paper_test
