#include "engine/lab/recommend.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace onggi::lab::recommend_test {
namespace {

SettingSummary grid(int rows, double us, double mm) {
  SettingSummary one;
  one.setting.rows = rows;
  one.p999 = us;
  one.errors.shape_rms = 1e-3 * mm;
  one.errors.shape_max = 4e-3 * mm;
  one.scripts = 3;
  return one;
}

TEST(Recommend, AFastMachineGetsTheCoarsestGridThatNobodyCanTellAndASlowOneTheFinestInTime) {
  const std::vector<SettingSummary> fast{grid(100, 2, 0.2), grid(200, 5, 0.04),
                                         grid(400, 20, 0.01)};
  const auto quick = recommend(fast, 1000.0);
  ASSERT_TRUE(quick);
  EXPECT_EQ(quick->chosen.setting.rows, 200);
  EXPECT_TRUE(quick->fine_enough && quick->in_time);
  EXPECT_EQ(quick->finer->setting.rows, 400);
  const auto slow =
      recommend({grid(100, 200, 0.2), grid(200, 500, 0.04), grid(400, 2000, 0.01)}, 1000.0);
  EXPECT_EQ(slow->chosen.setting.rows, 100);
  EXPECT_TRUE(!slow->fine_enough && slow->in_time);
  const auto hopeless = recommend({grid(100, 900, 0.2), grid(200, 1500, 0.04)}, 1000.0);
  EXPECT_EQ(hopeless->chosen.setting.rows, 100);
  EXPECT_FALSE(hopeless->in_time);
}

TEST(Recommend, OnlyWhatWorkedEverythingAndOnlyTheEngineAtThatRateIsRecommended) {
  std::vector<SettingSummary> all{grid(200, 5, 0.04), grid(400, 20, 0.01)};
  all[0].scripts = 2;
  EXPECT_EQ(recommend(all, 1000.0)->chosen.setting.rows, 400);
  EXPECT_FALSE(recommend(all, 2000.0));
  all[1].setting.model = AccuracySetting::Model::printed;
  EXPECT_EQ(recommend(all, 1000.0)->chosen.setting.rows, 200);
  EXPECT_FALSE(recommend({}, 1000.0));
}

TEST(Recommend, AForceThatAHandCanTellApartIsNotFineEnough) {
  std::vector<SettingSummary> all{grid(200, 5, 0.04), grid(400, 20, 0.01)};
  all[0].force_share = 0.1;
  EXPECT_EQ(recommend(all, 1000.0)->chosen.setting.rows, 400);
}

RC_GTEST_PROP(Recommend, NothingBeatsTheEdgeInBothAndAllElseIsBeaten, ()) {
  std::vector<SettingSummary> all;
  const auto n = *rc::gen::inRange(1, 30);
  for (int k = 0; k < n; ++k)
    all.push_back(grid(k + 8, *rc::gen::inRange(1, 20), *rc::gen::inRange(1, 20)));
  const auto edge = pareto_edge(all);
  const auto beats = [](const SettingSummary& a, const SettingSummary& b) {
    return a.p999 <= b.p999 && a.errors.shape_rms <= b.errors.shape_rms &&
           (a.p999 < b.p999 || a.errors.shape_rms < b.errors.shape_rms);
  };
  for (const std::size_t k : edge)
    RC_ASSERT(std::ranges::none_of(all, [&](const auto& one) { return beats(one, all[k]); }));
  for (std::size_t k = 0; k < all.size(); ++k)
    if (std::ranges::find(edge, k) == edge.end())
      RC_ASSERT(std::ranges::any_of(edge, [&](std::size_t e) {
        return beats(all[e], all[k]) ||
               (all[e].p999 == all[k].p999 && all[e].errors.shape_rms == all[k].errors.shape_rms);
      }));
}

TEST(Recommend, ASummaryIsTheWorstOfItsRows) {
  AccuracyRow a, b;
  a.script = "press";
  a.p999 = 3.0;
  a.errors.force_rms = 0.1;
  a.true_force = 10.0;
  b.script = "pull";
  b.p999 = 2.0;
  b.errors.force_rms = 0.05;
  b.true_force = 0.5;
  const auto all = summaries({a, b});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].p999, 3.0);
  EXPECT_EQ(all[0].errors.force_rms, 0.1);
  EXPECT_EQ(all[0].force_share, 0.1);
  EXPECT_EQ(all[0].scripts, 2);
  EXPECT_NEAR(all[0].share(), 0.003, 1e-12);
}

}  // namespace
}  // namespace onggi::lab::recommend_test
