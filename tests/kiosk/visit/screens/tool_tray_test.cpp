#include "kiosk/visit/screens/tool_tray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::tool_tray_test {
namespace {

constexpr std::uint8_t kRib = 3, kWire = 7;

/// Somebody at a wheel beside which a rib and a wire lie.
struct AtTheTray : Visitor {
  explicit AtTheTray(int w = 1280, int h = 720) {
    width = w;
    height = h;
    for (ShelfCard& card : shelf) {
      card.wheel.tools = {{kRib, "flat_rib", 0.0015, 0.045}, {kWire, "wire", 0.0005, 0.0005}};
      card.wheel.wire = kWire;
    }
    throw_a_pot();
    frames(2);
  }
  void set_down(double x, double y) {
    const auto at = *frame.pot->camera.project({x, y, 0});
    down(at.first, at.second);
    show();
  }
  /// The last that was asked of a hand at the clay.
  const HandInput& working() const {
    for (auto hand = wheel_commands.hands.rbegin(); hand != wheel_commands.hands.rend(); ++hand)
      if (hand->active) return *hand;
    return wheel_commands.hands.back();
  }
};

TEST(ToolTray, EveryToolLiesThereWithItsNameAndWhatItDoesOnEveryScreen) {
  for (const auto& [w, h] : {std::pair{1280, 720}, {1920, 1080}, {1080, 1920}, {720, 1280}}) {
    AtTheTray v(w, h);
    v.touch("throw.tools");
    v.frames(1);
    EXPECT_LT(v.frame.pot->opacity, 0.2) << "it does not disturb the words";
    for (const char* name : {"throw.tool.0", "throw.tool.1", "throw.tool.2"}) {
      const auto rect = v.visit->control(name);
      ASSERT_TRUE(rect) << name << " at " << w << "x" << h;
      EXPECT_GE(rect->x, 0);
      EXPECT_LE(rect->x + rect->w, static_cast<float>(w));
      EXPECT_LE(rect->y + rect->h, static_cast<float>(h));
      for (const auto& [other, place] : v.visit->controls())
        if (other != name) {
          EXPECT_FALSE(rect->contains(place.x + place.w / 2, place.y + place.h / 2)) << other;
        }
    }
    EXPECT_TRUE(v.visit->control("throw.done"));
    for (const char* words : {"Hands", "Flat rib", "Cutting wire", "Smooths a straight wall",
                              "Cuts the finished pot off"})
      EXPECT_NE(words_in(v.frame).find(words), std::string::npos) << words;
  }
}

TEST(ToolTray, WhatEachOfTheExhibitsToolsDoesIsReadOnTheUsualScreensInEveryLanguage) {
  for (const auto& [w, h] : {std::pair{1920, 1080}, {1080, 1920}, {1366, 768}})
    for (const char* code : {"en", "ko", "es", "fr", "de", "ja", "zh", "ar"}) {
      Visitor v;
      v.width = w;
      v.height = h;
      v.languages = {*content::Language::read(std::string("content/languages/") + code + ".toml")};
      v.put_tools_to_hand();
      v.throw_a_pot();
      v.touch("throw.tools");
      for (const SceneForVisitor::Tool& tool : v.wheel.tools)
        for (const char* words : {"", "_is"})
          EXPECT_NE(words_in(v.frame).find(v.languages[0].say("tool." + tool.name + words)),
                    std::string::npos)
              << tool.name << words << " in " << code << " at " << w << "x" << h;
    }
}

TEST(ToolTray, AChosenToolClosesTheDrawerAndATouchBesideTheToolsToo) {
  AtTheTray v;
  v.touch("throw.tools");
  v.touch("throw.tool.1");
  EXPECT_FALSE(v.visit->control("throw.tool.1"));
  EXPECT_GT(v.frame.pot->opacity, 0.9);
  v.touch("throw.tools");
  v.wheel_commands.hands.clear();
  v.down(static_cast<float>(v.width) - 3, 3);
  v.show();
  EXPECT_FALSE(v.visit->control("throw.tool.1"));
  for (const HandInput& hand : v.wheel_commands.hands) EXPECT_FALSE(hand.active);
}

TEST(ToolTray, ASceneWithoutToolsHasNoTray) {
  Visitor v;
  v.throw_a_pot();
  EXPECT_FALSE(v.visit->control("throw.tool.0"));
}

TEST(ToolTray, AToolIsOneHandsAndMeetsTheClayWithItsOwnFace) {
  AtTheTray v;
  v.touch("throw.tool.1");
  v.wheel_commands.hands.clear();
  v.set_down(0.055, 0.1);
  EXPECT_EQ(v.working().tool, kRib);
  EXPECT_EQ(v.working().side, SideWish::outside);
  EXPECT_NEAR(v.working().position.x, 0.055 + 0.0015, 1e-4);
  for (const HandInput& hand : v.wheel_commands.hands)
    EXPECT_FALSE(hand.active && hand.side == SideWish::inside);
}

TEST(ToolTray, ALongToolStaysOffTheWheelHead) {
  AtTheTray v;
  v.touch("throw.tool.1");
  v.set_down(0.05, 0.01);
  EXPECT_GE(v.working().position.y, 0.045);
}

TEST(ToolTray, BothHandsPutTheToolDown) {
  AtTheTray v;
  v.touch("throw.tool.1");
  v.touch("throw.both");
  v.set_down(0.05, 0.1);
  EXPECT_NE(v.working().tool, kRib);
  v.touch("throw.tool.1");
  v.touch("throw.tool.0");
  v.set_down(0.05, 0.1);
  EXPECT_NE(v.working().tool, kRib);
}

TEST(ToolTray, TheWireWaitsForTheWheelPassesUnderThePotAndEndsTheThrowing) {
  AtTheTray v;
  v.touch_clay();
  v.status.feedback.wheel_speed = 20;
  v.touch("throw.tool.2");
  EXPECT_EQ(v.wheel_commands.wheels.back(), 0.0);
  v.wheel_commands.hands.clear();
  v.frames(1);
  for (const HandInput& hand : v.wheel_commands.hands) EXPECT_FALSE(hand.active);
  v.status.feedback.wheel_speed = 0;
  double most = -1, least = 1;
  for (int i = 0; i < 200 && v.visit->screen() == ScreenId::throwing; ++i) {
    v.show();
    if (!v.working().active) continue;
    EXPECT_EQ(v.working().tool, kWire);
    EXPECT_LT(v.working().position.y, 0.004);
    most = std::max(most, v.working().position.x);
    least = std::min(least, v.working().position.x);
  }
  EXPECT_GT(most, 0.055);
  EXPECT_LT(least, -0.055);
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(ToolTray, APotThatAWireHasCutFreeIsDone) {
  AtTheTray v;
  v.status.feedback.cut_free = 0.99;
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  v.status.feedback.cut_free = 1;
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(CutAway, OpensWhenAHandGoesInsideAndClosesWhenItComesOut) {
  AtTheTray v;
  EXPECT_EQ(v.frame.pot->cut_away, 0);
  v.set_down(0.05, 0.1);  // Both hands, the wall between them.
  v.frames(1);
  EXPECT_GT(v.frame.pot->cut_away, 0.9);
  const auto at = *v.frame.pot->camera.project({0.05, 0.1, 0});
  v.up(at.first, at.second);
  v.frames(3);
  EXPECT_EQ(v.frame.pot->cut_away, 0);
  v.touch("throw.outside");
  v.set_down(0.05, 0.1);
  v.frames(1);
  EXPECT_EQ(v.frame.pot->cut_away, 0);
}

TEST(CutAway, WhoHasChosenKeepsIt) {
  AtTheTray v;
  v.touch("throw.cut");
  v.touch("throw.cut");
  v.set_down(0.05, 0.1);
  v.frames(1);
  EXPECT_EQ(v.frame.pot->cut_away, 0);
}

TEST(ToolTray, AControlNamesOneToolOrNone) {
  EXPECT_EQ(ToolTray::of_control("throw.tool.12"), std::optional<std::size_t>(12));
  for (const char* other : {"throw.tool.", "throw.tool.1x", "throw.tool.-1", "throw.both", ""})
    EXPECT_FALSE(ToolTray::of_control(other)) << other;
}

}  // namespace
}  // namespace onggi::screens::tool_tray_test
