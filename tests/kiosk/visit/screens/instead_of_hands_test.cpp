#include "kiosk/visit/screens/instead_of_hands.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::instead_of_hands_test {
namespace {

constexpr std::uint8_t kCuttingWire = 7, kRib = 3;

/// At a wheel with a paddle, and a coil if `built`.
struct AtAPaddle : Visitor {
  explicit AtAPaddle(bool built = false, bool by_buttons = false) {
    exhibit.screen.spoken = by_buttons;
    for (ShelfCard& card : shelf) {
      card.wheel.beating.emplace().face = 0.03;
      card.wheel.max_speed = 8.0;
      card.wheel.tools = {{0, "paddle", 0.03, 0.03},
                          {kCuttingWire, "wire", 0.0005, 0.0005},
                          {kRib, "flat_rib", 0.0015, 0.045}};
      card.wheel.wire = kCuttingWire;
      if (!built) continue;
      card.wheel.coil = 0.013;
      card.wheel.tools.insert(card.wheel.tools.begin(), {0, "coil", 0.0065, 0.0065});
    }
    throw_a_pot();
    frames(2);
  }
  void take(int tool) {
    touch("throw.tools");
    touch("throw.tool." + std::to_string(tool));
    frames(2);
  }
  const HandInput& outer_hand() const {
    return wheel_commands.hands[wheel_commands.hands.size() - 2];
  }
};

TEST(InsteadOfHands, ThePaddleIsHeldOnASlowWheelUntilAnotherToolIsTaken) {
  AtAPaddle v;
  EXPECT_FALSE(v.wheel_commands.paddle);
  const double fast = v.wheel_commands.wheels.back();
  v.take(1);
  EXPECT_TRUE(v.wheel_commands.paddle);
  EXPECT_EQ(v.wheel_commands.wheels.back(), WheelSpeed::kBeating);
  EXPECT_NE(words_in(v.frame).find("Hold the paddle on the wall"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("Beat the wall"), std::string::npos);
  v.take(3);
  EXPECT_FALSE(v.wheel_commands.paddle);
  EXPECT_EQ(v.wheel_commands.wheels.back(), fast);
  v.wheel_commands.hands.clear();
  const auto at = *v.frame.pot->camera.project({0.05, 0.5 * v.clay.rim_height(), 0});
  v.down(at.first, at.second);
  v.show();
  v.up(at.first, at.second);
  v.show();
  EXPECT_TRUE(std::ranges::any_of(v.wheel_commands.hands, [](const HandInput& hand) {
    return hand.active && hand.tool == kRib;
  })) << "the rib works, and no ball";
  v.take(1);
  v.take(0);
  EXPECT_FALSE(v.wheel_commands.paddle) << "bare hands";
}

TEST(InsteadOfHands, TheWireIsTakenInPlaceOfThePaddle) {
  AtAPaddle v;
  v.touch_clay();
  v.take(1);
  v.take(2);
  EXPECT_FALSE(v.wheel_commands.paddle);
  EXPECT_EQ(v.wheel_commands.wheels.back(), 0.0);
}

TEST(InsteadOfHands, CoilAndPaddleTakeEachOthersPlace) {
  AtAPaddle v(true);
  for (int n = 0; n < 2; ++n) {
    v.take(2);
    EXPECT_TRUE(v.wheel_commands.paddle);
    EXPECT_FALSE(v.wheel_commands.coil);
    v.take(1);
    EXPECT_FALSE(v.wheel_commands.paddle);
    EXPECT_TRUE(v.wheel_commands.coil);
  }
  EXPECT_EQ(v.wheel_commands.wheels.back(), WheelSpeed::kLaying);
  // A paddle may be faster than the rim takes a coil.
  v.take(2);
  for (int n = 0; n < 4; ++n) v.touch("throw.faster");
  v.take(1);
  EXPECT_LT(v.wheel_commands.wheels.back() * v.shelf[0].target.max_radius(), v.wheel.pace);
}

/// A built pot whose rings are laid: a cylinder of 8 mm of clay more than its vessel's wall.
struct AtAThickWall : AtAPaddle {
  AtAThickWall() : AtAPaddle(true) {
    for (ShelfCard& card : shelf) {
      card.wheel.coil = 0.013;
      const double high = clay.rim_height(), wide = clay.mean_outer(clay.rows() - 1);
      card.target.points = {
          {0.0, wide, 0.0}, {0.01, wide, wide - 0.006}, {high, wide, wide - 0.006}};
    }
  }
};

TEST(InsteadOfHands, APaddleStrikesAsHardAsTheWallInFrontOfItNeeds) {
  AtAThickWall v;
  v.take(2);
  ASSERT_TRUE(v.wheel_commands.paddle);
  v.frames(2);
  ASSERT_FALSE(v.wheel_commands.swings.empty());
  const script::Swings before = v.wheel_commands.swings.back();
  // The vessel is wider now: the anvil strikes harder.
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.outer += 0.02, p.height *= 1.001;
  v.frames(2);
  const script::Swings wider = v.wheel_commands.swings.back();
  EXPECT_GT(wider.anvil - wider.paddle, before.anvil - before.paddle + 0.1);
}

TEST(InsteadOfHands, WhenTheLastRingClosesThePaddleIsTakenUpAndHintsSayWhereItIsNeeded) {
  AtAThickWall v;
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.height *= 12.0;
  v.frames(2);
  v.take(1);
  ASSERT_TRUE(v.wheel_commands.coil);
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.height /= 12.0;
  v.frames(3);
  EXPECT_FALSE(v.wheel_commands.coil);
  EXPECT_TRUE(v.wheel_commands.paddle);
  EXPECT_NE(words_in(v.frame).find("Hold the paddle on the wall"), std::string::npos);
  ASSERT_TRUE(v.visit->sight());
  EXPECT_TRUE(v.visit->sight()->hint.press);
  v.take(0);
  v.frames(3);
  EXPECT_NE(words_in(v.frame).find("then “Paddle”"), std::string::npos);
  EXPECT_EQ(v.visit->sight()->tool, "throw.tool.2");
}

TEST(InsteadOfHands, APotThatIsStillToBeBeatenComesBackFromItsResultToThePaddle) {
  AtAThickWall v;
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.outer += 0.02;
  v.touch_clay();
  v.take(2);
  v.touch("throw.done");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  v.touch("back");
  v.frames(2);
  EXPECT_TRUE(v.wheel_commands.paddle);
}

TEST(InsteadOfHands, OfABeatenPotTheResultSpeaksOfBlowsAndOfAThrownOneOfHands) {
  Visitor v;
  VisitInputs world;
  world.languages = &v.languages;
  world.shelf = &v.shelf;
  v.shelf[0].built = v.shelf[0].wheel;
  v.shelf[0].built->beating.emplace();
  Desk desk(world);
  desk.card = 0;
  const score::Remark not_round{"remark.not_round", {}};
  EXPECT_NE(desk.said(not_round).find("Hold still"), std::string::npos);
  desk.built = true;
  EXPECT_NE(desk.said(not_round).find("Beat it"), std::string::npos);
}

TEST(InsteadOfHands, AFingerLeadsThePaddleAndLetsGoOfIt) {
  AtAPaddle v;
  v.take(1);
  const auto at = *v.frame.pot->camera.project({0.05, 0.5 * v.clay.rim_height(), 0});
  v.down(at.first, at.second);
  v.show();
  EXPECT_TRUE(v.outer_hand().active);
  EXPECT_EQ(v.outer_hand().tool, 0);
  EXPECT_GT(axis_distance(v.outer_hand().position),
            v.clay.radius_at(0.5 * v.clay.rim_height(), WallSide::outside) + v.wheel.tool_radius);
  v.up(at.first, at.second);
  v.show();
  EXPECT_FALSE(v.outer_hand().active);
}

TEST(InsteadOfHands, OneButtonBeatsTheWallOnceAndPressedAgainStops) {
  AtAPaddle v;
  v.take(1);
  v.touch("throw.show");
  v.frames(1);
  EXPECT_TRUE(v.outer_hand().active);
  const double low = v.outer_hand().position.y;
  v.frames(3);
  EXPECT_GT(v.outer_hand().position.y, low + 0.005) << "it goes up";
  v.touch("throw.show");
  v.frames(1);
  EXPECT_FALSE(v.outer_hand().active);
  EXPECT_TRUE(v.wheel_commands.paddle) << "the paddle stays in the hand";
  v.touch("throw.show");
  v.frames(12);
  EXPECT_FALSE(v.outer_hand().active) << "once up the wall";
}

TEST(InsteadOfHands, StrokesByButtonsSayHowThePaddleIsUsed) {
  AtAPaddle v(false, true);
  v.take(1);
  EXPECT_NE(words_in(v.frame).find("the paddle goes up the wall"), std::string::npos);
}

TEST(InsteadOfHands, APotThatComesBackFromItsResultIsNotBeaten) {
  AtAPaddle v;
  v.touch_clay();
  v.take(1);
  v.touch("throw.done");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  v.touch("back");
  v.frames(2);
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_FALSE(v.wheel_commands.paddle) << "the tray shows the hands";
}

TEST(InsteadOfHands, TwoVisitorsHaveNeither) {
  VisitInputs world;
  std::vector<ShelfCard> shelf(1);
  shelf[0].wheel.beating.emplace();
  world.shelf = &shelf;
  Desk desk(world);
  desk.card = 0;
  const InsteadOfHands two(desk, true), one(desk, false);
  EXPECT_FALSE(two.has("paddle"));
  EXPECT_TRUE(one.has("paddle"));
  EXPECT_FALSE(one.has("coil"));
  EXPECT_FALSE(one.has("flat_rib"));
}

}  // namespace
}  // namespace onggi::screens::instead_of_hands_test
