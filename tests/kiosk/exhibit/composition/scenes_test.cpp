#include "kiosk/exhibit/composition/scenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "kiosk/exhibit/tuning/grid_memory.h"
#include "kiosk/exhibit/tuning/machine.h"

namespace onggi::exhibit {
namespace {

class TunedScenes : public testing::Test {
 protected:
  TunedScenes() {
    std::string name = (std::filesystem::temp_directory_path() / "onggi-XXXXXX").string();
    folder = mkdtemp(name.data());
    exhibit.scene = folder / "scene.toml";
    std::ofstream(exhibit.scene) << "quality = \"auto\"\n[clay]\nrows = 321\n[walls]\n";
    plan.grids = {{100, 90}};
    plan.truth = {300, 260, 1000.0};
    plan.scene_rows = 100;
    plan.passes = 1;
  }
  ~TunedScenes() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
  std::filesystem::path memory() const {
    return *tuning::memory_of(folder, exhibit.scene, tuning::machine_name());
  }
  std::filesystem::path folder;
  settings::Exhibit exhibit;
  tuning::TunePlan plan;
};

TEST_F(TunedScenes, TheFirstStartLooksForAGridWhilePotsAreThrownAndTheSecondRemembersIt) {
  {
    Scenes scenes(exhibit);
    scenes.tune(folder, plan);
    EXPECT_EQ(scenes.of("").clay.rows, 321);  // nobody waits for it
    for (int n = 0; n < 4000 && scenes.of("").clay.rows == 321; ++n) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      scenes.take_up_tuned();
    }
    EXPECT_EQ(scenes.of("").clay.rows, 100);
    EXPECT_EQ(scenes.of("").clay.sectors, 90);
  }
  ASSERT_TRUE(tuning::remembered(memory()));
  Scenes again(exhibit);
  again.tune(folder, plan);
  EXPECT_EQ(again.of("").clay.rows, 100);
}

TEST_F(TunedScenes, WhatIsRememberedHoldsAtOnceAndAFixedSceneStaysAsItIsWritten) {
  ASSERT_TRUE(tuning::remember(memory(), {200, 180, 0.1, 0.2, 0.3, 4.0, true, true}, "any"));
  Scenes scenes(exhibit);
  EXPECT_EQ(scenes.of("").clay.rows, 321);  // a stepped visit asks for nothing
  scenes.tune(folder, plan);
  EXPECT_EQ(scenes.of("").clay.sectors, 180);
  std::ofstream(exhibit.scene) << "[clay]\nrows = 321\n";
  Scenes fixed(exhibit);
  fixed.tune(folder, plan);
  EXPECT_EQ(fixed.of("").clay.rows, 321);
}

// Sizes of engine/docs/tools.md: half a rib's thickness, the radius of what is round.
TEST(Scenes, ToolsLieInTheOrderOfTheWorkAndReachAsFarAsTheyAreMade) {
  settings::Exhibit exhibit;
  exhibit.scene = "config/scenes/studio.toml";
  const screens::SceneForVisitor wheel = Scenes(exhibit).wheel_of("");
  std::string order;
  for (const auto& tool : wheel.tools) order += tool.name + " ";
  EXPECT_EQ(order, "palm fingertip sponge flat_rib curved_rib loop_trimmer needle wire ");
  const auto reach = [&](std::size_t n) { return wheel.tools[n].reach; };
  EXPECT_NEAR(reach(0), 0.018, 1e-9);
  EXPECT_NEAR(reach(1), 0.008, 1e-9);
  EXPECT_NEAR(reach(2), 0.030, 1e-9);
  EXPECT_NEAR(reach(3), 0.0015, 1e-9);
  EXPECT_NEAR(wheel.tools[3].below, 0.045, 1e-9);
  EXPECT_NEAR(reach(6), 0.0006, 1e-9);
  EXPECT_EQ(wheel.tools[7].tool, *wheel.wire);
}

}  // namespace
}  // namespace onggi::exhibit
