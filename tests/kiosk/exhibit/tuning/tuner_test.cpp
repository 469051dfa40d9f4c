#include "kiosk/exhibit/tuning/tuner.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace onggi::tuning::tuner_test {
namespace {

// A coarse look: two grids and a rough truth.
TunePlan short_plan() {
  TunePlan plan;
  plan.grids = {{100, 90}, {200, 180}};
  plan.truth = {700, 550, 2000.0};
  plan.scene_rows = 400;
  return plan;
}
SceneDef studio() {
  SceneDef def;
  def.walls.emplace();
  def.propagation.emplace();
  def.volume.emplace();
  return def;
}

TEST(Tuner, WhatItPromisesHoldsWhenTheGridIsMeasuredAfresh) {
  SceneDef def = studio();
  const auto promised = tune("studio", def, short_plan());
  ASSERT_TRUE(promised);
  EXPECT_EQ(promised->rows, 200);
  def.clay.rows = promised->rows;
  def.clay.sectors = promised->sectors;
  // By another truth than the one it was found by.
  TunePlan afresh = short_plan();
  afresh.truth = {830, 610, 4000.0};
  afresh.scene_rows = 800;
  double tick_pct = 1e9;
  // What else a machine does only adds to a thread's time: the least of a few looks counts.
  for (int n = 0; n < 8 && tick_pct > promised->tick_pct; ++n) {
    const auto is = measure_grid("studio", def, afresh);
    ASSERT_TRUE(is);
    EXPECT_LE(is->shape_mm, promised->shape_mm);
    EXPECT_LE(is->worst_mm, promised->worst_mm);
    EXPECT_LE(is->force_pct, promised->force_pct);
    EXPECT_GT(is->shape_mm, 0.3 * promised->shape_mm);
    tick_pct = std::min(tick_pct, is->tick_pct);
  }
  EXPECT_LE(tick_pct, promised->tick_pct);
  EXPECT_GT(tick_pct, 0.0);
}

// A promise that nothing could break is none: errors are the same bits each time, times are not.
TEST(Tuner, PromisesAQuarterMoreErrorThanItMeasuredAndNoMore) {
  SceneDef def = studio();
  const auto promised = tune("studio", def, short_plan());
  ASSERT_TRUE(promised);
  def.clay.rows = promised->rows;
  def.clay.sectors = promised->sectors;
  const auto is = measure_grid("studio", def, short_plan());
  ASSERT_TRUE(is);
  EXPECT_NEAR(promised->shape_mm, 1.25 * is->shape_mm, 1e-12);
  EXPECT_NEAR(promised->worst_mm, 1.25 * is->worst_mm, 1e-12);
  EXPECT_NEAR(promised->force_pct, 1.25 * is->force_pct, 1e-9);
  EXPECT_EQ(promised->fine_enough, is->fine_enough);
}

TEST(Tuner, AScenesOwnClayDecidesAndNotADefault) {
  SceneDef soft = studio(), firm = studio();
  firm.contact.relaxation_time = 0.1;
  const auto a = measure_grid("soft", soft, short_plan());
  const auto b = measure_grid("firm", firm, short_plan());
  ASSERT_TRUE(a && b);
  EXPECT_NE(a->shape_mm, b->shape_mm);
}

TEST(Tuner, AGridOfThePrintedModelIsPartOfIt) {
  SceneDef paper;
  each_effect(paper, [](auto& effect) { effect.reset(); });
  paper.paper.emplace();
  const auto none = tune("paper", paper, short_plan());
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().what.find("printed model"), std::string::npos);
}

TEST(Tuner, GivenUpItSaysSoAndWithoutGridsThereIsNone) {
  TunePlan plan = short_plan();
  int asked = 0;
  plan.give_up = [&] { return ++asked > 2; };
  const auto none = tune("studio", studio(), plan);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().exit_code, 1);
  plan = short_plan();
  plan.grids.clear();
  EXPECT_FALSE(tune("studio", studio(), plan));
}

}  // namespace
}  // namespace onggi::tuning::tuner_test
