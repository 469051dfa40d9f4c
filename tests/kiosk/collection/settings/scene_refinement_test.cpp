#include <gtest/gtest.h>

#include "kiosk/collection/settings/scene_file.h"
#include "tests/support/convergence.h"

// The scenes that ship, at other ticks and on other grids: engine/docs/convergence.md.
namespace onggi::settings::scene_refinement_test {
namespace {

using refinement::refine_grids;
using refinement::refine_ticks;
using refinement::Refined;

SceneDef shipped(const std::string& name) {
  SceneRead read = read_scene("config/scenes/" + name + ".toml");
  EXPECT_TRUE(read.problems.empty()) << name;
  return std::move(read.def);
}

TEST(SceneRefinement, APotIsTheSameAtAnyTickAndOnAnyGridInEveryScene) {
  for (const char* name : {"first_touch", "studio", "master"})
    for (const refinement::Work& work : refinement::scene_works(name, shipped(name)))
      for (const bool ticks : {true, false}) {
        const Refined r = ticks ? refinement::refine_ticks(work) : refinement::refine_grids(work);
        // A lump's rows take turns in strips, each shifted by a part of a row: the last two grids
        // of `master` between two hands are 0.6 um apart, and of order 0.82.
        const double least = !ticks && work.name == "master, two hands" ? 0.8 : 0.9;
        EXPECT_TRUE(r.order.shape > least || r.finest.shape < refinement::kFloor.shape)
            << work.name << ' ' << r.order.shape << ' ' << r.finest.shape;
        EXPECT_TRUE(r.order.force > 0.9 || r.finest.force < refinement::kFloor.force) << work.name;
        EXPECT_TRUE(r.order.impulse > 0.9 || r.finest.impulse < refinement::kFloor.impulse)
            << work.name << ' ' << r.order.impulse << ' ' << r.finest.impulse;
        EXPECT_LT(r.impulse_off, 0.01) << work.name;
      }
}

TEST(SceneRefinement, ThePrintedModelIsAnotherAtEveryTickAndOnEveryGrid) {
  for (const refinement::Work& work : refinement::scene_works("paper", shipped("paper"))) {
    EXPECT_GT(refinement::refine_ticks(work).impulse_off, 0.5);
    EXPECT_GT(refinement::refine_grids(work).impulse_off, 0.5);
  }
}

}  // namespace
}  // namespace onggi::settings::scene_refinement_test
