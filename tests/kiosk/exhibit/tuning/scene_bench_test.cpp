#include "kiosk/exhibit/tuning/scene_bench.h"

#include <gtest/gtest.h>

#include "kiosk/exhibit/tuning/machine.h"

namespace onggi::tuning::scene_bench_test {
namespace {

TEST(SceneBench, ASceneComesNearerToItsFinestSelfOnFinerGrids) {
  const auto bench = SceneBench::create("bare", lab::accuracy_scripts()[0].def, 400, 1e-3);
  ASSERT_TRUE(bench);
  const auto coarse = bench->rows({50, 45}, 2), fine = bench->rows({200, 180}, 2);
  ASSERT_TRUE(coarse && fine);
  ASSERT_EQ(coarse->size(), 2u);  // one hand, and two
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_LT((*fine)[n].errors.shape_rms, 0.3 * (*coarse)[n].errors.shape_rms);
    EXPECT_EQ((*fine)[n].setting.sectors, 180);
    EXPECT_GT((*fine)[n].p50, 0.0);
    EXPECT_GE((*fine)[n].p999, (*fine)[n].p50);
    EXPECT_GE((*fine)[n].worst, (*fine)[n].p999);
  }
}

TEST(SceneBench, WhatIsNoSceneIsAProblem) {
  SceneDef none;
  none.clay.height = -1.0;
  EXPECT_FALSE(SceneBench::create("none", none, 100, 1e-3));
}

TEST(Machine, HasANameAndCoresAndAClockThatOnlyWorkMoves) {
  EXPECT_NE(machine_name().find("core"), std::string::npos);
  const double before = thread_us();
  volatile double sum = 0.0;
  for (int n = 0; n < 1000000; ++n) sum = sum + 1.0;
  EXPECT_GT(thread_us(), before);
}

}  // namespace
}  // namespace onggi::tuning::scene_bench_test
