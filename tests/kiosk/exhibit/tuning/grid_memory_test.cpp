#include "kiosk/exhibit/tuning/grid_memory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::tuning::grid_memory_test {
namespace {

class GridMemory : public testing::Test {
 protected:
  GridMemory() { std::ofstream(scene) << "[walls]\n"; }
  const files::test::ScratchFolder scratch_;
  const std::filesystem::path folder = scratch_.path(), scene = folder / "studio.toml";
};

TEST_F(GridMemory, AGridIsRememberedForThisSceneOnThisMachineOnly) {
  const TunedGrid grid{400, 360, 0.015, 0.4, 0.5, 6.25, true, true};
  const auto here = memory_of(folder, scene, "A, 2 cores");
  ASSERT_TRUE(here);
  EXPECT_FALSE(remembered(*here));
  ASSERT_TRUE(remember(*here, grid, "A, 2 cores"));
  EXPECT_EQ(remembered(*here), grid);
  EXPECT_EQ(*memory_of(folder, scene, "A, 2 cores"), *here);
  EXPECT_NE(*memory_of(folder, scene, "B, 8 cores"), *here);
  std::ofstream(scene) << "[walls]\nsupport = 0.02\n";
  EXPECT_NE(*memory_of(folder, scene, "A, 2 cores"), *here);
  EXPECT_FALSE(memory_of(folder, folder / "none.toml", "A, 2 cores"));
}

TEST_F(GridMemory, WhatMakesNoSenseIsAsIfNothingWereKept) {
  const auto memory = folder / "grid.txt";
  for (const char* text :
       {"", "rows 400", "onggi grid, kind 2\nrows 400\n",
        "onggi grid, kind 1\nrows 4\nsectors 9\nshape_mm 1\nworst_mm 1\nforce_pct 1\ntick_pct 1\n"
        "fine_enough 1\nin_time 1\n"}) {
    std::ofstream(memory) << text;
    EXPECT_FALSE(remembered(memory)) << text;
  }
}

}  // namespace
}  // namespace onggi::tuning::grid_memory_test
