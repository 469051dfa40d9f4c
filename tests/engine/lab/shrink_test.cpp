#include "engine/lab/shrink.h"

#include <gtest/gtest.h>

#include "engine/lab/scene_fields.h"

namespace onggi::lab::shrink_test {
namespace {

TEST(Shrink, EverySimplerTrialIsAScene) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const Trial trial = random_trial(seed);
    for (const Trial& less : simpler(trial)) {
      ASSERT_TRUE(validate(less.def)) << words_of(less);
      ASSERT_FALSE(less.strokes.empty());
      EXPECT_LE(less.ticks(), trial.ticks());
    }
  }
}

TEST(Shrink, LeavesOfALongTrialWhatBreaksTheInvariantAndNothingElse) {
  // The printed model, and one tick on its axis among two thousand.
  TrialPlan plan;
  plan.ticks = 2000;
  plan.nonsense = plan.ends = false;
  SceneDef def = bare({});
  def.clay.rows = 40;
  def.clay.sectors = 32;
  def.paper.emplace();
  Trial trial = random_hands(def, 4, plan);
  for (Stroke& stroke : trial.strokes)
    for (Stroke::Part& part : stroke.hand) part.begins.active = false;
  Stroke bad;
  bad.ticks = 7;
  bad.hand[0].begins = {{0.0, 0.1, 0.0}, true};
  bad.hand[0].ends = {0.0, 0.1, 0.0};
  trial.strokes.insert(trial.strokes.begin() + 9, bad);
  const TrialResult result = run_trial(trial);
  ASSERT_TRUE(result.breach);
  const Shrunk least = least_of(trial, *result.breach, {}, 1'000'000);
  EXPECT_EQ(least.breach.invariant, result.breach->invariant);
  EXPECT_EQ(least.trial.strokes.size(), 1u);
  EXPECT_EQ(least.trial.ticks(), 1u);
  EXPECT_GT(least.ticks, 10u);
}

TEST(Shrink, StopsWhenItsTicksAreUsedUp) {
  Trial trial = random_trial(3);
  trial.def = bare(trial.def);
  trial.def.paper.emplace();
  Stroke bad;
  bad.hand[0].begins = {{0.0, 0.1, 0.0}, true};
  bad.hand[0].ends = {0.0, 0.1, 0.0};
  trial.strokes.push_back(bad);
  const TrialResult result = run_trial(trial);
  ASSERT_TRUE(result.breach);
  EXPECT_LT(least_of(trial, *result.breach, {}, 10).ticks, trial.ticks() + 10);
}

TEST(TrialRun, LooksAgainWithOtherVectorsAndInAMirror) {
  TrialPlan plan;
  plan.ticks = 300;
  plan.nonsense = plan.ends = false;
  const Trial trial = random_hands(bare({}), 2, plan);
  EXPECT_EQ(run_trial(trial).ticks, trial.ticks());
  const TrialResult twice = run_trial(trial, {.twice = true});
  EXPECT_EQ(twice.ticks, 2 * trial.ticks());
  EXPECT_NE(twice.hash, 0u);
  EXPECT_EQ(run_trial(trial, {.mirror = true}).ticks, 2 * trial.ticks());
}

TEST(TrialRun, GivesUpWhenItIsToldTo) {
  TrialPlan plan;
  plan.ticks = 20000;
  const Trial trial = random_hands(bare({}), 2, plan);
  const TrialResult result = run_trial(trial, {.twice = true, .give_up = [] { return true; }});
  EXPECT_FALSE(result.breach);
  EXPECT_LT(result.ticks, 2000u);
}

TEST(MirrorDifference, IsNoneOfAPotAndItsImageAndSeesADentOnTheWrongSide) {
  Clay clay = std::move(*Clay::create({}));
  Clay image = std::move(*Clay::create({}));
  clay.outer_mut(100)[3] -= 0.001f;
  EXPECT_NEAR(mirror_difference(clay, image), 0.001 / 360, 1e-9);
  image.outer_mut(100)[356] -= 0.001f;
  EXPECT_EQ(mirror_difference(clay, image), 0.0);
}

}  // namespace
}  // namespace onggi::lab::shrink_test
