#include "kiosk/exhibit/scenes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "kiosk/tuning/grid_memory.h"
#include "kiosk/tuning/machine.h"

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

}  // namespace
}  // namespace onggi::exhibit
