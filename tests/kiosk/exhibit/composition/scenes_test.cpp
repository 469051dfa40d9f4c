#include "kiosk/exhibit/composition/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "engine/contact/tool.h"
#include "kiosk/exhibit/tuning/grid_memory.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::exhibit::scenes_test {
namespace {

class TunedScenes : public testing::Test {
 protected:
  TunedScenes() {
    exhibit.scene = folder / "scene.toml";
    std::ofstream(exhibit.scene) << "quality = \"auto\"\n[clay]\nrows = 321\n[walls]\n";
    plan.grids = {{100, 90}};
    plan.truth = {300, 260, 1000.0};
    plan.scene_rows = 100;
    plan.passes = 1;
  }
  std::filesystem::path memory() const {
    return *tuning::memory_of(folder, exhibit.scene, tuning::machine_name());
  }
  const files::test::ScratchFolder scratch_;
  const std::filesystem::path folder = scratch_.path();
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
  const screens::SceneForVisitor wheel = Scenes(exhibit).wheel_of(content::Vessel{});
  const auto tray = [](const auto& tool) { return find_tool_shape(tool.name)->tray; };
  EXPECT_TRUE(std::ranges::is_sorted(wheel.tools, {}, tray));
  EXPECT_EQ(wheel.tools.size(), tool_shapes().size() - 1) << "the ball is the bare finger's";
  EXPECT_EQ(wheel.tools.front().name, "palm");
  EXPECT_EQ(wheel.tools.back().name, "wire") << "it ends the pot";
  EXPECT_EQ(wheel.tools.back().tool, *wheel.wire);
  const auto of = [&](std::string_view name) {
    return *std::ranges::find(wheel.tools, name, &screens::SceneForVisitor::Tool::name);
  };
  EXPECT_NEAR(of("palm").reach, 0.018, 1e-9);
  EXPECT_NEAR(of("fingertip").reach, 0.008, 1e-9);
  EXPECT_NEAR(of("sponge").reach, 0.030, 1e-9);
  EXPECT_NEAR(of("flat_rib").reach, 0.0015, 1e-9);
  EXPECT_NEAR(of("flat_rib").below, 0.045, 1e-9);
  EXPECT_NEAR(of("needle").reach, 0.0006, 1e-9);
}

}  // namespace
}  // namespace onggi::exhibit::scenes_test
