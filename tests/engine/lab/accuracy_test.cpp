#include "engine/lab/accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::lab::accuracy_test {
namespace {

using Model = AccuracySetting::Model;

// A clock by which every tick takes a microsecond.
double counting() {
  static double now = 0.0;
  return now += 1.0;
}

AccuracyScript named(const std::string& name) {
  for (AccuracyScript& script : accuracy_scripts())
    if (script.name == name) return std::move(script);
  ADD_FAILURE() << name;
  return {};
}
constexpr TruthPlan kCoarse{800, 720, 4000.0};

AccuracyRow row_of(const AccuracyScript& script, const Truth& truth, Model model, int rows,
                   int sectors) {
  AccuracySetting setting;
  setting.model = model;
  setting.rows = rows;
  setting.sectors = sectors;
  return measure_accuracy(script, truth, setting, counting);
}

TEST(Accuracy, TheEngineLeavesAndFeelsWhatASecondLawInDoublesDoesInEveryScript) {
  for (const AccuracyScript& script : accuracy_scripts()) {
    if (script.name == "throw")
      continue;  // its razor edges want a finer truth than a test has time for
    const Truth truth = truth_of(script, kCoarse);
    const AccuracyRow row = row_of(script, truth, Model::shipped, 200, 180);
    EXPECT_LT(row.errors.shape_rms, 2.5e-5) << script.name;
    EXPECT_LT(row.errors.shape_max, 2e-4) << script.name;
    EXPECT_LT(row.errors.force_rms, 0.02 * truth.mean_force) << script.name;
    EXPECT_LT(row.errors.volume, 0.003) << script.name;
    EXPECT_GT(truth.displaced, 5e-7) << script.name;
    EXPECT_GT(truth.mean_force, 0.03) << script.name;
  }
}

// A vase's flanks lean, and there the push turns with the wall.
TEST(Accuracy, OnAWallThatLeansTheEngineFeelsWhatTheSecondLawDoes) {
  AccuracyScript script = named("throw");
  script.seconds = 1.0;
  const Truth truth = truth_of(script, {400, 360, 2000.0});
  const AccuracyRow row = row_of(script, truth, Model::shipped, 400, 360);
  EXPECT_LT(row.errors.force_rms, 0.02 * truth.mean_force);
}

TEST(Accuracy, OfFinerGridsTheEngineComesNearerInAllThreeErrorsAndThePrintedForceRunsAway) {
  const AccuracyScript script = named("press");
  const Truth truth = truth_of(script, kCoarse);
  AccuracyRow before = row_of(script, truth, Model::shipped, 100, 90);
  AccuracyRow printed = row_of(script, truth, Model::printed, 100, 90);
  for (const int times : {2, 4}) {
    const AccuracyRow ours = row_of(script, truth, Model::shipped, 100 * times, 90 * times);
    EXPECT_LT(ours.errors.shape_rms, 0.5 * before.errors.shape_rms);
    EXPECT_LT(ours.errors.force_rms, 0.5 * before.errors.force_rms);
    before = ours;
    const AccuracyRow theirs = row_of(script, truth, Model::printed, 100 * times, 90 * times);
    EXPECT_NEAR(theirs.mean_force / printed.mean_force, 4.0, 0.15);
    printed = theirs;
  }
}

TEST(Accuracy, PlainFloatsAndTheEngineAreOneLaw) {
  const AccuracyScript script = named("collar");
  const Truth truth = truth_of(script, kCoarse);
  const AccuracyRow plain = row_of(script, truth, Model::plain, 200, 180);
  const AccuracyRow ours = row_of(script, truth, Model::shipped, 200, 180);
  EXPECT_NEAR(plain.errors.shape_rms, ours.errors.shape_rms, 2e-7);
  EXPECT_NEAR(plain.displaced / ours.displaced, 1.0, 1e-4);
}

TEST(Accuracy, ATruthIsItsOwnWithoutError) {
  const AccuracyScript script = named("press");
  const Truth truth = truth_of(script, {200, 180, 1000.0});
  AccuracySetting same{.model = Model::plain, .doubles = true, .rows = 200, .sectors = 180};
  const AccuracyRow row = measure_accuracy(script, truth, same, counting);
  EXPECT_LT(row.errors.shape_max, 1e-12);
  EXPECT_LT(row.errors.force_rms, 1e-12);
  EXPECT_LT(row.errors.volume, 1e-12);
}

TEST(Accuracy, TheThreeErrorsAreOfTheirOwnThings) {
  const AccuracyScript script = named("press");
  const Truth truth = truth_of(script, {200, 180, 1000.0});
  AccuracySetting same{.model = Model::plain, .doubles = true, .rows = 200, .sectors = 180};
  Truth other = truth;
  for (double& r : other.face[0].radius) r += 1e-4;
  for (auto& window : other.force) window[0].x += 0.5;
  const AccuracyRow row = measure_accuracy(script, other, same, counting);
  EXPECT_NEAR(row.errors.shape_rms, 1e-4, 1e-9);
  EXPECT_NEAR(row.errors.force_rms, 0.5, 1e-9);
  EXPECT_LT(row.errors.volume, 1e-12);
}

TEST(Accuracy, TicksAreTimedWhileClayIsPressedAndOfSeveralPassesTheLeastCounts) {
  const AccuracyScript script = named("press");
  const Truth truth = truth_of(script, {100, 90, 1000.0});
  static double late = 0.0;
  static long asked = 0;
  const auto slower_first = [] { return late += ++asked < 2100 ? 5.0 : 1.0; };
  const AccuracyRow row =
      measure_accuracy(script, truth, {.rows = 50, .sectors = 45}, slower_first, 2);
  EXPECT_EQ(row.p50, 1.0);
  EXPECT_EQ(row.worst, 1.0);
}

TEST(Accuracy, ThePrintedModelHasNoWallThatTwoHandsCouldPull) {
  EXPECT_FALSE(can_work(named("pull"), {.model = Model::printed}));
  EXPECT_TRUE(can_work(named("near_axis"), {.model = Model::printed}));
}

TEST(Accuracy, PercentilesAreOfTheValuesThemselves) {
  EXPECT_EQ(percentile({}, 0.5), 0.0);
  EXPECT_EQ(percentile({3.0, 1.0, 2.0}, 0.5), 2.0);
  EXPECT_EQ(percentile({3.0, 1.0, 2.0}, 1.0), 3.0);
  EXPECT_EQ(percentile({3.0, 1.0, 2.0}, 0.0), 1.0);
}

}  // namespace
}  // namespace onggi::lab::accuracy_test
