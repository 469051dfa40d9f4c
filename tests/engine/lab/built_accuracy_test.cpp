#include "engine/lab/built_accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace onggi::lab::built_accuracy_test {
namespace {

// A clock by which every tick takes a microsecond.
double one_a_tick() {
  static double now = 0.0;
  return now += 1.0;
}

BuiltScript named(const std::string& name) {
  for (BuiltScript& script : built_scripts())
    if (script.name == name) return std::move(script);
  ADD_FAILURE() << name;
  return {};
}

AccuracyRow row_of(const BuiltScript& script, const BuiltTruth& truth, int rows,
                   double rate = 1000.0) {
  AccuracySetting setting;
  setting.rows = rows;
  setting.sectors = rows * 9 / 10;
  setting.rate_hz = rate;
  return measure_built(script, truth, setting, one_a_tick);
}

TEST(BuiltAccuracy, ARingOfCoilComesNearerToItsClosedFormOnFinerGrids) {
  const BuiltScript script = named("coil");
  const BuiltTruth truth = truth_of(script, 0, 1500);
  AccuracyRow before = row_of(script, truth, 100);
  EXPECT_LT(before.errors.shape_rms, 2e-4);
  for (const int rows : {200, 400}) {
    const AccuracyRow row = row_of(script, truth, rows);
    EXPECT_LT(row.errors.shape_rms, 0.5 * before.errors.shape_rms) << rows;
    EXPECT_LT(row.errors.volume, 5e-5) << rows;
    before = row;
  }
  EXPECT_LT(before.errors.shape_rms, 2.5e-5);
  EXPECT_LT(before.errors.shape_max, 1e-4);
  EXPECT_NEAR(before.displaced / truth.volume, 1.0, 5e-5);
}

TEST(BuiltAccuracy, BlowsComeNearerToASecondProgramOnFinerGridsWithTheSquareOfTheStep) {
  const BuiltScript script = named("blows");
  const BuiltTruth truth = truth_of(script, 1000, 940);
  AccuracyRow before = row_of(script, truth, 100);
  EXPECT_LT(before.errors.shape_rms, 3e-6);
  for (const int rows : {200, 400}) {
    const AccuracyRow row = row_of(script, truth, rows);
    EXPECT_LT(row.errors.shape_rms, 0.3 * before.errors.shape_rms) << rows;
    EXPECT_LT(row.errors.volume, 1e-3) << rows;
    before = row;
  }
  EXPECT_LT(before.errors.shape_rms, 2.5e-7);
  EXPECT_GT(truth.volume, 5e-6);
}

// Of a long tick, which the engine divides, a blow takes the first part: 0.7 mm of this wall's way.
TEST(BuiltAccuracy, ABlowLandsInTheSamePlaceAtEveryTickThatTheEngineDoesNotDivide) {
  const BuiltScript script = named("blows");
  const BuiltTruth truth = truth_of(script, 400, 360);
  const double usual = row_of(script, truth, 100).errors.shape_rms;
  for (const double rate : {2000.0, 4000.0})
    EXPECT_NEAR(row_of(script, truth, 100, rate).errors.shape_rms, usual, 1e-12) << rate;
  EXPECT_NEAR(row_of(script, truth, 100, 500.0).errors.shape_rms, 5e-6, 1e-6);
}

TEST(BuiltAccuracy, ATruthHalfAsFineIsHardlyAnother) {
  for (const BuiltScript& script : built_scripts()) {
    const BuiltTruth fine = truth_of(script, 1000, 940), half = truth_of(script, 500, 470);
    for (std::size_t side = 0; side < 2; ++side)
      EXPECT_LT(difference(half.face[side], fine.face[side]).rms, 2e-7) << script.name;
  }
}

TEST(BuiltAccuracy, ATruthThatIsOffIsToldByShapeAndByVolume) {
  const BuiltScript script = named("coil");
  BuiltTruth truth = truth_of(script, 0, 720);
  const AccuracyRow right = row_of(script, truth, 400);
  for (FaceGrid& face : truth.face)
    for (double& r : face.radius) r += 1e-3;
  truth.volume *= 1.02;
  const AccuracyRow off = row_of(script, truth, 400);
  EXPECT_NEAR(off.errors.shape_rms, 1e-3, 3.0 * right.errors.shape_rms);
  EXPECT_NEAR(off.errors.volume, 0.0196, 1e-4);
}

TEST(BuiltAccuracy, TimedAreTheTicksOfTheWorkAloneAndForceIsNotCompared) {
  // Each call of this clock is later by one more, so a tick's time is its number.
  static double now, step;
  const auto later = [] { return now += (step += 1.0); };
  const BuiltScript blows = named("blows");
  const BuiltTruth truth = truth_of(blows, 200, 180);
  AccuracySetting setting{.rows = 50, .sectors = 45};
  now = step = 0.0;
  const AccuracyRow row = measure_built(blows, truth, setting, later);
  // Of the eight blows the fourth is the middle one, and the last comes 120 ms before the end.
  EXPECT_EQ(row.p50, 2.0 * 420.0);
  EXPECT_EQ(row.worst, 2.0 * 900.0);
  EXPECT_TRUE(std::isnan(row.errors.force_rms));
  EXPECT_TRUE(std::isnan(row.true_force));
}

TEST(BuiltAccuracy, NoOtherModelBuildsAndCoilsNeedRoomForTwiceTheRows) {
  const BuiltScript coil = named("coil"), blows = named("blows");
  EXPECT_FALSE(can_work(blows, {.model = AccuracySetting::Model::plain}));
  EXPECT_FALSE(can_work(blows, {.model = AccuracySetting::Model::printed}));
  EXPECT_TRUE(can_work(coil, {.rows = 3200, .sectors = 2160}));
  EXPECT_FALSE(can_work(coil, {.rows = 6400, .sectors = 2880}));
  EXPECT_TRUE(can_work(blows, {.rows = 6400, .sectors = 2880}));
}

TEST(BuiltAccuracy, ItsScriptsAreKnownByName) {
  for (const BuiltScript& script : built_scripts()) EXPECT_TRUE(is_built(script.name));
  for (const AccuracyScript& script : accuracy_scripts()) EXPECT_FALSE(is_built(script.name));
}

}  // namespace
}  // namespace onggi::lab::built_accuracy_test
