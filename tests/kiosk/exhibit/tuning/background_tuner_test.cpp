#include "kiosk/exhibit/tuning/background_tuner.h"

#include <gtest/gtest.h>

#include <chrono>

namespace onggi::tuning::background_tuner_test {
namespace {

TunePlan short_plan() {
  TunePlan plan;
  plan.grids = {{100, 90}};
  plan.truth = {300, 260, 1000.0};
  plan.scene_rows = 100;
  plan.passes = 1;
  return plan;
}

TEST(BackgroundTuner, FindsAGridWhileItsOwnerGoesOnAndTellsItOnce) {
  BackgroundTuner tuner("bare", SceneDef{}, short_plan());
  std::optional<Result<TunedGrid>> found;
  while (!(found = tuner.take())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  ASSERT_TRUE(*found);
  EXPECT_EQ((*found)->rows, 100);
  EXPECT_FALSE(tuner.take());
}

TEST(BackgroundTuner, AnExhibitThatIsClosedDoesNotWaitForIt) {
  TunePlan plan = short_plan();
  plan.grids.assign(100000, {100, 90});  // hours of them
  BackgroundTuner tuner("bare", SceneDef{}, plan);
  EXPECT_FALSE(tuner.take());
}

}  // namespace
}  // namespace onggi::tuning::background_tuner_test
