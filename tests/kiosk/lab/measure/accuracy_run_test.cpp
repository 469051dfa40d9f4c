#include "kiosk/lab/measure/accuracy_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::measure::accuracy_run_test {
namespace {

using lab::AccuracySetting;
using Model = AccuracySetting::Model;

TEST(AccuracyPlan, GoesFromFiftyRowsToTheFinestGridAndTurnsEveryKnob) {
  for (const bool quick : {true, false}) {
    const AccuracyPlan plan{.quick = quick};
    const auto grids = plan.grids();
    EXPECT_GE(grids.size(), 6u);
    EXPECT_EQ(grids.front(), (std::array{50, 45}));
    EXPECT_EQ(grids.back(), (std::array{6400, 2880}));
    const auto settings = plan.settings();
    const auto any = [&](auto&& is) { return std::ranges::any_of(settings, is); };
    for (const double rate : {500.0, 1000.0, 2000.0, 4000.0})
      for (const Model model : {Model::shipped, Model::printed})
        EXPECT_TRUE(any([&](const auto& s) { return s.rate_hz == rate && s.model == model; }));
    for (const auto rule : {lab::TimeRule::printed, lab::TimeRule::exact, lab::TimeRule::shipped})
      EXPECT_TRUE(any([&](const auto& s) { return s.model == Model::plain && s.rule == rule; }));
    for (const auto sum : {lab::Quadrature::none, lab::Quadrature::area, lab::Quadrature::edges})
      EXPECT_TRUE(
          any([&](const auto& s) { return s.model == Model::plain && s.quadrature == sum; }));
    EXPECT_TRUE(any([](const auto& s) { return s.substeps == 4; }));
    EXPECT_TRUE(any([](const auto& s) { return s.model == Model::plain && s.doubles; }));
    for (std::size_t n = 0; n < settings.size(); ++n)
      for (std::size_t k = 0; k < n; ++k) EXPECT_FALSE(settings[n] == settings[k]);
    // The truth is finer than any, in space and in time, and its places are no grid's.
    for (const AccuracySetting& s : settings) {
      EXPECT_LT(s.rate_hz * s.substeps, plan.truth().rate_hz);
      EXPECT_NE(plan.truth().sectors % s.sectors, 0);
    }
  }
}

lab::AccuracyRow row_of(int rows, double mm, double impulse) {
  lab::AccuracyRow row;
  row.script = "press";
  row.setting.rows = rows;
  row.setting.sectors = rows;
  row.errors.shape_rms = 1e-3 * mm;
  row.impulse = impulse;
  row.displaced = 1e-6;
  return row;
}

TEST(AccuracyOrders, AreOfThreeGridsEachTwiceAsFineAndOfNothingElse) {
  const auto orders =
      orders_of({row_of(100, 0.8, 1.16), row_of(200, 0.4, 1.04), row_of(400, 0.2, 1.01)});
  ASSERT_EQ(orders.size(), 3u);
  EXPECT_NEAR(orders[0].order.p, 1.0, 1e-9);
  EXPECT_FALSE(orders[0].order.asymptotic);  // a shape with corners has 1.5
  EXPECT_NEAR(orders[1].order.p, 2.0, 1e-9);
  EXPECT_TRUE(orders[1].order.asymptotic);
  EXPECT_TRUE(converged(orders[2]));  // the same volume on each
  EXPECT_TRUE(orders_of({row_of(100, 0.8, 1), row_of(200, 0.4, 1)}).empty());
  EXPECT_EQ(finest_order(orders, Model::shipped, lab::TimeRule::shipped, "press", "grid", "force"),
            &orders[1]);
  EXPECT_EQ(finest_order(orders, Model::printed, lab::TimeRule::printed, "press", "grid", "force"),
            nullptr);
}

TEST(AccuracyOrders, InTheTickTheMiddleRuleIsOfSecondOrderAndThePrintedOneOfNone) {
  const lab::AccuracyScript script = lab::accuracy_scripts()[3];
  AccuracySetting law{.model = Model::plain};
  law.rows = 200;
  law.sectors = 180;
  const auto middle = tick_orders(script, law, AccuracyPlan::kRates);
  ASSERT_EQ(middle.size(), 2u);
  EXPECT_TRUE(middle.back().order.asymptotic) << middle.back().order.p;
  law.rule = lab::TimeRule::printed;
  EXPECT_FALSE(tick_orders(script, law, AccuracyPlan::kRates).back().order.asymptotic);
}

}  // namespace
}  // namespace onggi::measure::accuracy_run_test
