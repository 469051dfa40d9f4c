#include "kiosk/exhibit/composition/pot_on_wheel.h"

#include <gtest/gtest.h>

#include <chrono>
#include <deque>
#include <fstream>
#include <thread>
#include <vector>

#include "engine/scene/lump.h"
#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/engine/profile/shapes.h"
#include "tests/kiosk/exhibit/composition/no_renderer.h"
#include "tests/kiosk/ground/files/disk.h"

namespace onggi::exhibit::pot_on_wheel_test {
namespace {

class Nowhere final : public test::NoRenderer {};

/// A wheel, and two vessels: the first is thrown on the largest grid that onggi check accepts.
class PotOnWheelTest : public ::testing::Test {
 protected:
  PotOnWheelTest() {
    write("large.toml", "[clay]\nrows = 2048\nsectors = 2048\n[walls]\n");
    write("small.toml", "[clay]\nrows = 60\nsectors = 48\n[walls]\n");
    exhibit.scene = folder.path() / "small.toml";
    exhibit.vessel_scenes["large"] = folder.path() / "large.toml";
    for (const char* id : {"large", "small"}) {
      vessels.emplace_back().id = id;
      vessels.back().mesh = revolve(section_of(shapes::jar()), 12);
      cards.push_back({&vessels.back(), 0, {}, 1.0, {}});
      cards.back().target = scaled(shapes::jar(), workspace_scale(shapes::jar()));
    }
  }
  void write(const char* name, const char* text) const {
    std::ofstream(folder.path() / name) << text;
  }
  static void wait(PotOnWheel& pot) {
    for (int n = 0; n < 20'000 && !pot.made(); ++n)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_TRUE(pot.made());
  }

  files::test::ScratchFolder folder;
  settings::Exhibit exhibit;
  std::deque<content::Vessel> vessels;
  std::vector<screens::ShelfCard> cards;
  loop::SteppedWheel wheel;
  Nowhere renderer;
};

// In attract a frame stood for 0.8 s at each new pot. A lump of four million elements is never
// there at once, unless this thread makes it.
TEST_F(PotOnWheelTest, NoFrameMakesALumpOnTheLargestGrid) {
  const Scenes scenes(exhibit);
  PotOnWheel pot(scenes, wheel, renderer, 1, false);
  pot.start({0, true, "follow"}, cards[0]);
  EXPECT_FALSE(pot.made());
  wait(pot);
  ASSERT_TRUE(pot.put(cards[0]));
  EXPECT_EQ(pot.def().clay.rows, 2048);
  EXPECT_EQ(pot.card(), 0);
}

TEST_F(PotOnWheelTest, AWishThatComesWhileALumpIsMadeReplacesIt) {
  const Scenes scenes(exhibit);
  PotOnWheel pot(scenes, wheel, renderer, 1, false);
  pot.start({0, true, "follow"}, cards[0]);
  pot.start({0, false, ""}, cards[0]);
  pot.start({1, false, ""}, cards[1]);
  wait(pot);
  EXPECT_EQ(pot.wished_card(), 1);
  ASSERT_TRUE(pot.put(cards[1]));
  EXPECT_EQ(pot.def().clay.rows, 60);
  EXPECT_EQ(pot.card(), 1);
  EXPECT_FALSE(pot.made());
  wheel.advance(3);
  EXPECT_FALSE(wheel.status().scripted) << "a visitor's own hands";
}

TEST_F(PotOnWheelTest, ASteppedVisitHasItsPotAtOnce) {
  const Scenes scenes(exhibit);
  PotOnWheel pot(scenes, wheel, renderer, 1, true);
  EXPECT_FALSE(pot.made());
  pot.start({1, true, "follow"}, cards[1]);
  ASSERT_TRUE(pot.made());
  ASSERT_TRUE(pot.put(cards[1]));
  wheel.advance(3);
  EXPECT_TRUE(wheel.status().scripted);
}

TEST_F(PotOnWheelTest, AVesselIsBuiltInItsBuiltSceneAndThrownInTheOther) {
  write("built.toml", "[clay]\nrows = 400\nsectors = 48\n[volume]\n[building]\ncoil = 0.02\n");
  exhibit.built_scene = folder.path() / "small.toml";
  vessels[1].built = true;
  EXPECT_EQ(Scenes(exhibit).built(vessels[1]), nullptr) << "nothing is built without coils";
  exhibit.built_scene = folder.path() / "built.toml";
  exhibit.build = false;
  EXPECT_EQ(Scenes(exhibit).built(vessels[1]), nullptr) << "the museum does not want it";
  exhibit.build = true;
  const Scenes scenes(exhibit);
  EXPECT_EQ(scenes.built(vessels[0]), nullptr) << "this one was thrown";
  ASSERT_NE(scenes.built(vessels[1]), nullptr);
  const screens::SceneForVisitor shown = scenes.for_visitor(*scenes.built(vessels[1]), vessels[1]);
  EXPECT_EQ(shown.coil, 0.02);
  const std::size_t others = scenes.wheel_of(vessels[1]).tools.size();
  ASSERT_EQ(shown.tools.size(), others + 1);
  EXPECT_EQ(shown.tools[0].name, "coil");
  EXPECT_EQ(scenes.for_visitor(scenes.of("small"), vessels[1]).coil, std::nullopt);
  PotOnWheel pot(scenes, wheel, renderer, 1, true);
  for (const bool built : {true, false}) {
    screens::StartPot wish{1, false, ""};
    wish.built = built;
    pot.start(wish, cards[1]);
    ASSERT_TRUE(pot.made());
    ASSERT_TRUE(pot.put(cards[1]));
    EXPECT_EQ(pot.def().building.has_value(), built);
    EXPECT_EQ(wheel.view().coil.diameter, built ? 0.02 : 0.0);
    EXPECT_EQ(pot.def().clay.height < 0.011, built) << "a floor, or a lump";
  }
}

TEST_F(PotOnWheelTest, AVesselsPaddleLeavesItsFaceWhereThereIsAPaddle) {
  write("built.toml", "[clay]\nrows = 400\nsectors = 48\n[volume]\n[building]\n[beating]\n");
  exhibit.built_scene = folder.path() / "built.toml";
  exhibit.build = true;
  vessels[1].built = true;
  vessels[1].paddle = PrintsDef::grid;
  vessels[0].built = true;
  const Scenes scenes(exhibit);
  const SceneDef& scene = *scenes.built(vessels[1]);
  EXPECT_FALSE(scene.prints) << "other vessels are built in it, too";
  ASSERT_TRUE(scenes.for_visitor(scene, vessels[1]).prints);
  EXPECT_EQ(scenes.for_visitor(scene, vessels[1]).prints->paddle, PrintsDef::grid);
  EXPECT_FALSE(scenes.for_visitor(scene, vessels[0]).prints);
  SceneDef cut = scene;
  cut.prints.emplace().paddle = PrintsDef::grid;
  EXPECT_EQ(scenes.for_visitor(cut, vessels[0]).prints->paddle, PrintsDef::grid);
  vessels[0].paddle = PrintsDef::plain;
  EXPECT_EQ(scenes.for_visitor(cut, vessels[0]).prints->paddle, PrintsDef::plain)
      << "a vessel that says plain has plain wood";
  EXPECT_FALSE(scenes.for_visitor(scene, vessels[0]).prints);
  vessels[0].paddle.reset();
  PotOnWheel pot(scenes, wheel, renderer, 1, true);
  for (const bool built : {true, false})
    for (const int card : {0, 1}) {
      screens::StartPot wish{card, false, ""};
      wish.built = built;
      pot.start(wish, cards[static_cast<std::size_t>(card)]);
      ASSERT_TRUE(pot.made());
      ASSERT_TRUE(pot.put(cards[static_cast<std::size_t>(card)]));
      EXPECT_EQ(pot.def().prints.has_value(), built && card == 1) << built << card;
    }
}

}  // namespace
}  // namespace onggi::exhibit::pot_on_wheel_test
