#include "kiosk/visit/screens/coil_at_wheel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kiosk/visit/screens/stroke_board.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::coil_at_wheel_test {
namespace {

constexpr std::uint8_t kWire = 7;

void stretch(Profile& target, double times) {
  for (ProfilePoint& p : target.points) p.height *= times;
}

/// At a pot that is built of coils. Its lump is as high as its vessel unless `floor`.
struct AtABuiltPot : Visitor {
  explicit AtABuiltPot(bool floor = true, bool by_buttons = false, double pace = 0.5) {
    exhibit.screen.spoken = by_buttons;
    for (ShelfCard& card : shelf) {
      card.wheel.coil = 0.013;
      card.wheel.max_speed = 8.0;
      card.wheel.pace = pace;
      card.wheel.tools = {{0, "coil", 0.0065, 0.0065},
                          {kWire, "wire", 0.0005, 0.0005},
                          {3, "flat_rib", 0.0015, 0.045}};
      card.wheel.wire = kWire;
      if (floor) stretch(card.target, 3.0);
    }
    throw_a_pot();
    frames(2);
  }
  /// Hand 0 is at the pot.
  bool holds() const { return wheel_commands.hands[wheel_commands.hands.size() - 2].active; }
};

TEST(CoilAtWheel, APotThatIsBuiltBeginsWithACoilInTheHandOnASlowWheel) {
  AtABuiltPot v;
  EXPECT_TRUE(v.wheel_commands.coil);
  EXPECT_EQ(v.wheel_commands.wheels.back(), WheelSpeed::kLaying);
  EXPECT_NE(words_in(v.frame).find("Hold the coil on the rim"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("Lay a ring"), std::string::npos);
  v.touch("throw.tools");
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("Builds the wall, ring on ring"), std::string::npos);
  v.touch("throw.tool.0");
  v.frames(3);
  EXPECT_FALSE(v.wheel_commands.coil) << "bare hands";
  EXPECT_EQ(v.wheel_commands.wheels.back(), 8.0) << "at their own speed";
  EXPECT_NE(words_in(v.frame).find("then “Coil”"), std::string::npos);
  v.touch("throw.tools");
  v.touch("throw.tool.1");
  EXPECT_TRUE(v.wheel_commands.coil);
  EXPECT_EQ(v.wheel_commands.wheels.back(), WheelSpeed::kLaying);
}

TEST(CoilAtWheel, APotThatIsHighEnoughBeginsWithTheHands) {
  AtABuiltPot v(false);
  EXPECT_FALSE(v.wheel_commands.coil);
}

// The wheel keeps the coil for the pot on it, so the screens must say what is held when they are
// shown anew.
TEST(CoilAtWheel, APotThatComesBackFromItsResultIsNotHeldWithTheCoilThatClosedIt) {
  AtABuiltPot v;
  ASSERT_TRUE(v.wheel_commands.coil);
  for (ShelfCard& card : v.shelf) stretch(card.target, 1.0 / 3.0);  // high enough now
  v.touch("throw.done");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  v.touch("back");
  v.frames(1);
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_FALSE(v.wheel_commands.coil) << "the tray shows the hands";
}

TEST(CoilAtWheel, WhoHoldsOnBuildsNoHigherThanTheVesselAndANewTouchDoes) {
  AtABuiltPot v;
  const auto at = *v.frame.pot->camera.project({0.05, v.clay.rim_height(), 0});
  v.down(at.first, at.second);
  v.show();
  ASSERT_TRUE(v.holds());
  for (ShelfCard& card : v.shelf) stretch(card.target, 1.0 / 3.0);
  v.show();
  EXPECT_FALSE(v.holds());
  v.up(at.first, at.second);
  v.down(at.first, at.second);
  v.show();
  EXPECT_TRUE(v.holds());
}

TEST(CoilAtWheel, FreshClayIsBuiltFromItsFloorAgain) {
  AtABuiltPot v;
  v.touch("throw.tools");
  v.touch("throw.tool.0");
  v.frames(1);
  ASSERT_FALSE(v.wheel_commands.coil);
  v.touch("throw.renew");
  EXPECT_TRUE(v.wheel_commands.coil);
}

TEST(CoilAtWheel, OneHandAloneTakesThePlaceOfTheCoil) {
  AtABuiltPot v;
  v.touch("throw.tools");
  v.touch("throw.outside");
  EXPECT_FALSE(v.wheel_commands.coil);
}

TEST(CoilAtWheel, ACoilIsLaidNoFasterThanTheRimTakesIt) {
  AtABuiltPot v;
  const double widest = v.shelf[0].target.max_radius();
  for (int n = 0; n < 8; ++n) v.touch("throw.faster");
  EXPECT_LT(v.wheel_commands.wheels.back() * widest, v.wheel.pace);
  EXPECT_GT(v.wheel_commands.wheels.back() * widest, 0.7 * v.wheel.pace);
  v.touch("throw.slower");
  EXPECT_GT(v.wheel_commands.wheels.back(), 0.0);
}

TEST(CoilAtWheel, TheWireIsTakenInPlaceOfTheCoil) {
  AtABuiltPot v;
  v.touch_clay();
  v.touch("throw.tools");
  v.touch("throw.tool.2");
  EXPECT_FALSE(v.wheel_commands.coil) << "a hand with a coil could not cut";
  EXPECT_EQ(v.wheel_commands.wheels.back(), 0.0);
}

TEST(CoilAtWheel, AFingerLeadsTheCoilAndTheButtonLaysARing) {
  AtABuiltPot v;
  const auto at = *v.frame.pot->camera.project({0.05, v.clay.rim_height(), 0});
  v.down(at.first, at.second);
  v.show();
  EXPECT_TRUE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
  EXPECT_GT(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].position.y,
            v.clay.rim_height());
  v.up(at.first, at.second);
  v.show();
  EXPECT_FALSE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
  v.touch("throw.show");
  EXPECT_TRUE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
  v.touch("throw.show");
  EXPECT_FALSE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active) << "and stops";
}

// The words of the buttons' sentence, and a second press, went on as if hands made a stroke.
TEST(CoilAtWheel, StrokesByButtonsLayRingsUntilTheWallIsThereAndSaySo) {
  AtABuiltPot v(true, true);
  ASSERT_TRUE(v.visit->control("throw.part.2")) << "strokes by buttons";
  EXPECT_NE(words_in(v.frame).find("Lay one more ring."), std::string::npos);
  v.touch("throw.ask.1");
  EXPECT_TRUE(v.holds());
  EXPECT_NE(words_in(v.frame).find("A ring is being laid."), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find("The hands are working"), std::string::npos);
  v.touch("throw.ask.2");
  EXPECT_TRUE(v.holds()) << "a second stroke does not stop it";
  for (ShelfCard& card : v.shelf) stretch(card.target, 1.0 / 3.0);
  v.show();
  EXPECT_FALSE(v.wheel_commands.coil) << "from here on strokes are made";
  EXPECT_TRUE(v.visit->control("throw.show")) << "where the focus was, there is a button";
}

TEST(CoilAtWheel, FasterNeverStopsAWheelHoweverSlowItMustBe) {
  AtABuiltPot v(true, false, 0.03);
  const double before = v.wheel_commands.wheels.back();
  ASSERT_GT(before, 0.0);
  v.touch("throw.faster");
  EXPECT_GE(v.wheel_commands.wheels.back(), before);
  v.frames(3);
  EXPECT_EQ(words_in(v.frame).find("has stopped"), std::string::npos);
  v.touch("throw.slower");
  EXPECT_EQ(v.wheel_commands.wheels.back(), 0.0);
}

TEST(CoilAtWheel, TheHintNamesTheButtonAsItStands) {
  AtABuiltPot v;
  v.touch("throw.tools");
  v.touch("throw.tool.0");
  v.frames(3);
  EXPECT_NE(words_in(v.frame).find("Touch “Tools”, then “Coil”."), std::string::npos);
  v.touch("throw.tools");
  v.touch("throw.tool.3");
  v.frames(3);
  EXPECT_NE(words_in(v.frame).find("Touch “Flat rib”, then “Coil”."), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::coil_at_wheel_test
