#include "kiosk/exhibit/tuning/scene_writer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "kiosk/collection/settings/scene_file.h"
#include "tests/kiosk/ground/files/scratch_folder.h"

namespace onggi::tuning::scene_writer_test {
namespace {

using files::test::content;

class SceneWriter : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& text) const {
    std::ofstream(folder / "mine.toml") << text;
    return folder / "mine.toml";
  }
  const files::test::ScratchFolder folder;
};

TEST_F(SceneWriter, AnotherGridLeavesEveryOtherLineAsItWas) {
  const auto scene = file(
      "# of the museum\nquality = \"auto\"\n\n[clay]  # a lump\nrows = 600\nsectors = 512 # fine\n"
      "wall_min = 0.003\n\n[walls]\nsupport = 0.03  # rows = 9\n");
  ASSERT_TRUE(write_grid(scene, 300, 270, "tuned"));
  EXPECT_EQ(content(scene),
            "# of the museum\n\n[clay]  # a lump\nrows = 300  # tuned\nsectors = 270\n"
            "wall_min = 0.003\n\n[walls]\nsupport = 0.03  # rows = 9\n");
  const settings::SceneRead read = settings::read_scene(scene);
  EXPECT_TRUE(read.problems.empty());
  EXPECT_EQ(read.def.clay.rows, 300);
  EXPECT_EQ(read.def.clay.sectors, 270);
  EXPECT_TRUE(read.def.walls);
}

TEST_F(SceneWriter, ASceneWithoutAClayGetsOne) {
  const auto scene = file("[walls]\n");
  ASSERT_TRUE(write_grid(scene, 300, 270, "tuned"));
  EXPECT_EQ(settings::read_scene(scene).def.clay.sectors, 270);
}

TEST_F(SceneWriter, WhatIsNoSceneOrWouldBeNoneStaysAsItWas) {
  const std::string wrong = "[clay]\nrows = \"many\"\n";
  EXPECT_FALSE(write_grid(file(wrong), 300, 270, "tuned"));
  EXPECT_EQ(content(folder / "mine.toml"), wrong);
  const std::string dotted = "clay.rows = 500\nclay.sectors = 512\n";
  const auto told = write_grid(file(dotted), 300, 270, "tuned");
  ASSERT_FALSE(told);
  EXPECT_EQ(told.error().exit_code, 1);
  EXPECT_EQ(content(folder / "mine.toml"), dotted);
  EXPECT_FALSE(write_grid(folder / "none.toml", 300, 270, "tuned"));
}

}  // namespace
}  // namespace onggi::tuning::scene_writer_test
