#include "kiosk/visit/screens/fire_button.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::fire_button_test {
namespace {

/// At a pot whose rings are laid, and whose wall is thicker than its vessel's; the paddle is 2.
struct AtAWetWall : Visitor {
  AtAWetWall() {
    const double high = clay.rim_height(), wide = clay.mean_outer(clay.rows() - 1);
    for (ShelfCard& card : shelf) {
      card.wheel.beating.emplace().face = 0.03;
      card.wheel.moisture.emplace();
      card.wheel.coil = 0.013;
      card.wheel.tools = {{0, "coil", 0.0065, 0.0065}, {0, "paddle", 0.03, 0.03}};
      card.target.points = {
          {0.0, wide, 0.0}, {0.01, wide, wide - 0.006}, {high, wide + 0.02, wide + 0.014}};
    }
    status.feedback.wetness = 0.35;
    throw_a_pot();
    frames(2);
  }
  void take(int tool) {
    touch("throw.tools");
    touch("throw.tool." + std::to_string(tool));
    frames(2.5);
  }
  bool hangs() const { return !wheel_commands.fires.empty() && wheel_commands.fires.back(); }
  bool says(const std::string& what) const {
    return words_in(frame).find(what) != std::string::npos;
  }
  bool there(const char* control) const { return visit->control(control).has_value(); }
};

TEST(FireButton, StandsWhereWaterDoesWhileACoilOrAPaddleIsInTheHand) {
  AtAWetWall v;
  v.take(0);
  EXPECT_TRUE(v.there("throw.water"));
  EXPECT_FALSE(v.there("throw.fire"));
  v.touch("throw.water");
  ASSERT_TRUE(v.wheel_commands.waters.back());
  v.take(2);
  v.touch("throw.fire");
  v.take(0);
  EXPECT_FALSE(v.hangs()) << "charcoal neither";
  v.touch("throw.water");
  for (const int held : {1, 2}) {
    v.take(held);
    EXPECT_TRUE(v.there("throw.fire"));
    EXPECT_FALSE(v.there("throw.water"));
    EXPECT_FALSE(v.wheel_commands.waters.back()) << "who cannot see it cannot turn it off";
  }
}

TEST(FireButton, HangsCharcoalGlowsAndTakesItOutAgain) {
  AtAWetWall v;
  v.take(2);
  EXPECT_EQ(v.frame.pot->embers, 0.0);
  v.touch("throw.fire");
  EXPECT_TRUE(v.hangs());
  v.frames(2);
  EXPECT_GT(v.frame.pot->embers, 0.9);
  v.touch("throw.fire");
  EXPECT_FALSE(v.hangs());
  v.frames(4);
  EXPECT_EQ(v.frame.pot->embers, 0.0);
  v.key(view::Key::water);
  EXPECT_TRUE(v.hangs()) << "the key of water, where its button is charcoal's";
}

TEST(FireButton, IsAskedForWhileBlowsSoundDullAndGoesOutWhenTheClayIsDry) {
  AtAWetWall v;
  v.take(2);
  EXPECT_TRUE(v.says("Touch “Charcoal”")) << words_in(v.frame);
  v.touch("throw.fire");
  v.frames(2.5);
  EXPECT_FALSE(v.says("Touch “Charcoal”")) << "it hangs";
  v.status.feedback.wetness = 0.1;
  v.frames(1);
  EXPECT_TRUE(v.hangs()) << "it may dry on";
  v.status.feedback.wetness = 0.01;
  v.frames(1);
  EXPECT_FALSE(v.hangs());
  EXPECT_FALSE(v.says("Touch “Charcoal”"));
}

TEST(FireButton, WhoLetsThePaddleWorkByItselfNeedNotAskForIt) {
  AtAWetWall v;
  v.take(2);
  v.touch("throw.show");
  EXPECT_TRUE(v.hangs());
}

TEST(FireButton, GoesWithThePot) {
  AtAWetWall v;
  v.take(2);
  v.touch("throw.fire");
  v.touch("throw.wheel");
  v.touch("throw.renew");
  EXPECT_FALSE(v.hangs()) << "over new clay";
  v.take(2);
  v.touch("throw.fire");
  ++v.status.scene_serial;
  v.frames(3);
  EXPECT_EQ(v.frame.pot->embers, 0.0);
}

}  // namespace
}  // namespace onggi::screens::fire_button_test
