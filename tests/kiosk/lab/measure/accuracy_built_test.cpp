#include "kiosk/lab/measure/accuracy_built.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace onggi::measure::accuracy_built_test {
namespace {

using lab::AccuracySetting;
using ::testing::HasSubstr;
using ::testing::Not;

lab::AccuracyRow row(const char* script, int rows, double rate, double us) {
  lab::AccuracyRow out;
  out.script = script;
  out.setting.rows = rows;
  out.setting.sectors = rows * 9 / 10;
  out.setting.rate_hz = rate;
  out.p50 = 0.5 * us;
  out.p999 = us;
  out.errors = {1.25e-5, 6e-5, std::numeric_limits<double>::quiet_NaN(), 3e-4};
  return out;
}

TEST(AccuracyBuilt, TurnsGridAndTickOfTheEngineAloneFromTheCoarsestGridToTheFinest) {
  for (const bool quick : {true, false}) {
    const AccuracyPlan plan{.quick = quick};
    const auto settings = built_settings(plan, lab::built_scripts().back());
    for (const AccuracySetting& one : settings)
      EXPECT_EQ(one.model, AccuracySetting::Model::shipped);
    const auto of_coils = built_settings(plan, lab::built_scripts().front());
    EXPECT_EQ(std::ranges::max(of_coils, {}, &AccuracySetting::rows).rows,
              plan.quick ? 1600 : 3200);
    for (const auto& grid : plan.grids())
      EXPECT_TRUE(std::ranges::any_of(settings, [&](const AccuracySetting& one) {
        return one.rows == grid[0] && one.sectors == grid[1] && one.rate_hz == 1000.0;
      })) << grid[0];
    for (const double rate : AccuracyPlan::kRates)
      EXPECT_TRUE(std::ranges::any_of(settings, [&](const AccuracySetting& one) {
        return one.rows == AccuracyPlan::kUsual[0] && one.rate_hz == rate;
      })) << rate;
  }
}

TEST(AccuracyBuilt, ItsTruthsAreSureToATenthOfAMicrometre) {
  const auto truths = built_truths({.quick = true});
  ASSERT_EQ(truths.size(), lab::built_scripts().size());
  for (const KnownBuilt& known : truths) {
    EXPECT_GT(known.apart, 0.0) << known.script.name;
    EXPECT_LT(known.apart, 1e-7) << known.script.name;
  }
}

TEST(AccuracyBuilt, FinerGridsAndMorePassesAreMoreWork) {
  const lab::BuiltScript script = lab::built_scripts().front();
  AccuracySetting setting;
  const double usual = work_of(script, setting, 1);
  EXPECT_NEAR(work_of(script, setting, 3), 3.0 * usual, 1e-12);
  setting.rows *= 2;
  EXPECT_GT(work_of(script, setting, 1), usual);
}

TEST(AccuracyBuilt, ARecommendationGoesByNeitherCoilsNorBlows) {
  const auto rows = without_built({row("coil", 400, 1000.0, 3.0), row("press", 400, 1000.0, 7.0),
                                   row("blows", 400, 1000.0, 70.0), row("built", 50, 1000.0, 1.0)});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].script, "press");
  EXPECT_EQ(rows[1].script, "built");
}

TEST(AccuracyBuilt, APersonReadsGridsAndTicksOfCoilsAndBlowsButNoForce) {
  const std::string text =
      words_of_built({row("press", 400, 1000.0, 7.0), row("coil", 400, 1000.0, 3.0),
                      row("blows", 800, 1000.0, 500.0), row("blows", 400, 4000.0, 200.0)});
  EXPECT_THAT(text, HasSubstr("coil     400 x 360      1 kHz       1.5       3.0    0.3 %"));
  EXPECT_THAT(text, HasSubstr("blows    800 x 720      1 kHz     250.0     500.0   50.0 %"));
  EXPECT_THAT(text, HasSubstr("0.01250      0.0600   0.0300 %"));
  const std::string by_tick = text.substr(text.find("by tick"));
  EXPECT_THAT(by_tick, HasSubstr("blows    400 x 360      4 kHz     100.0     200.0   80.0 %"));
  EXPECT_THAT(by_tick, Not(HasSubstr("800 x 720")));
  EXPECT_THAT(text, Not(HasSubstr("press")));
  EXPECT_THAT(text, Not(HasSubstr("nan")));
}

TEST(AccuracyBuilt, OfATableWithoutThemNothingIsSaid) {
  EXPECT_EQ(words_of_built({row("press", 400, 1000.0, 7.0)}), "");
}

}  // namespace
}  // namespace onggi::measure::accuracy_built_test
