#include "kiosk/exhibit/composition/curators_pot.h"

#include <gtest/gtest.h>

#include <fstream>

#include "kiosk/collection/decoration/write_decoration.h"
#include "kiosk/ground/files/virtual_display.h"
#include "tests/kiosk/program/commands/temporary_exhibit.h"

namespace onggi::exhibit::curators_pot_test {
namespace {

using decoration::Step;
using Kind = view::InputEvent::Kind;

/// A curator with a vessel in a window that nobody sees.
class ACurator : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = files::VirtualDisplay::ensure(640, 360);
    if (!made) GTEST_SKIP() << "no display, and Xvfb is not installed";
    display_ = std::move(*made);
  }
  void TearDown() override {
    table_.reset();
    display_.reset();
  }
  void take_up(const std::string& vessel, const std::string& config = "config/exhibit.toml") {
    auto table =
        CuratorsPot::open(config, "content/vessels/" + vessel, "en",
                          {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"});
    ASSERT_TRUE(table) << to_text(table.error());
    table_ = std::move(*table);
    frame();
  }
  bool frame(double after = 0.05) { return table_->frame(now_ += after); }
  void press(const std::string& control) {
    ASSERT_TRUE(table_->visit().control(control)) << control;
    table_->visit().activate(control, now_);
    frame();
  }
  /// A finger on the middle of the pot, which goes down by `way` pixels.
  void touch(float way) {
    const view::Rect pot = *table_->visit().control("decorate.mark");
    view::InputEvent finger{Kind::pointer_down, pot.x + pot.w / 2, pot.y + pot.h / 2};
    table_->visit().input(finger, now_);
    finger.kind = Kind::pointer_move;
    for (int n = 0; n < 10; ++n) {
      finger.y += way / 10;
      table_->visit().input(finger, now_);
      frame();
    }
    finger.kind = Kind::pointer_up;
    table_->visit().input(finger, now_);
    while (table_->visit().decorated_pot()->busy()) frame();
  }

  std::unique_ptr<files::VirtualDisplay> display_;
  std::unique_ptr<CuratorsPot> table_;
  double now_ = 0;
};

TEST_F(ACurator, DrawsOnTheVesselWithItsToolsAndTheFileHasTheSteps) {
  take_up("moon_jar");
  ASSERT_EQ(table_->visit().screen(), screens::ScreenId::decorate);
  touch(0);
  press("decorate.tool.1");
  touch(30);
  EXPECT_TRUE(frame());
  table_->visit().activate("decorate.on", now_);
  EXPECT_FALSE(frame()) << "Save does not end it";
  decoration::Decoration drawn = table_->decoration();
  ASSERT_EQ(drawn.steps.size(), 2u);
  EXPECT_EQ(drawn.steps[0].kind, Step::band);
  drawn.sources = "A book", drawn.simplified = "Nothing";
  const commands::ScratchFolder folder;
  const auto file = folder / "decoration.toml";
  std::ofstream(file) << decoration::to_toml(drawn);
  const auto read = decoration::check_decoration(file);
  EXPECT_TRUE(read.problems.empty()) << to_text(read.problems.front());
  EXPECT_EQ(read.decoration.steps.size(), 2u);
}

TEST_F(ACurator, MayLeaveForLunch) {
  take_up("tea_bowl");
  touch(0);
  for (int minutes = 0; minutes < 90; ++minutes) ASSERT_TRUE(frame(60));
  EXPECT_EQ(table_->visit().screen(), screens::ScreenId::decorate);
  EXPECT_FALSE(table_->decoration().steps.empty());
}

TEST_F(ACurator, WhoDrawsNothingGetsNoSteps) {
  take_up("olla");
  table_->visit().activate("decorate.on", now_);
  EXPECT_FALSE(frame());
  EXPECT_TRUE(table_->decoration().steps.empty());
}

TEST_F(ACurator, IsToldThatTheExhibitHasNoWayForAVessel) {
  const commands::ScratchFolder folder;
  const auto table = CuratorsPot::open(
      commands::write_exhibit(folder, "first_touch", ""), "content/vessels/moon_jar", "en",
      {.width = 640, .height = 360, .visible = false, .title = "Onggi tests"});
  ASSERT_FALSE(table);
  EXPECT_NE(to_text(table.error()).find("no way to decorate"), std::string::npos);
}

}  // namespace
}  // namespace onggi::exhibit::curators_pot_test
