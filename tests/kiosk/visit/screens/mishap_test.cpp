#include "kiosk/visit/screens/mishap.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::mishap_test {
namespace {

using view::Key;

// A hand on the clay of a pot that stands and is whole.
void hold_a_whole_pot(Visitor& v) {
  v.throw_a_pot();
  v.status.can_restore = true;
  v.frames(1);
  for (const char* words : {"It collapsed", "The wall tore"})
    EXPECT_EQ(words_in(v.frame).find(words), std::string::npos);
  v.down(900, 300);
  v.show();
}

TEST(Mishap, APotThatFellIsSaidKindlyAndOneTouchGoesBackToBeforeTheFall) {
  Visitor v;
  hold_a_whole_pot(v);
  v.status.feedback.fallen = true;
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("It collapsed"), std::string::npos);
  EXPECT_FALSE(v.wheel_commands.hands.back().active) << "the hand is off the clay";
  v.up(900, 300);
  v.touch("throw.restore");
  EXPECT_EQ(v.wheel_commands.restored, 1);
  v.status.feedback.fallen = false;
  v.frames(1);
  EXPECT_EQ(words_in(v.frame).find("It collapsed"), std::string::npos);
}

TEST(Mishap, AfterAFallTheKeysLeadStraightToTheWayBack) {
  Visitor v;
  v.throw_a_pot();
  v.status.can_restore = true;
  v.status.feedback.fallen = true;
  v.frames(1);
  v.key(Key::enter);
  EXPECT_EQ(v.visit->focus(), "throw.restore");
  v.key(Key::enter);
  EXPECT_EQ(v.wheel_commands.restored, 1);
}

TEST(Mishap, AWallThatToreIsSaidKindlyWithTheReasonAndOneTouchGoesBack) {
  Visitor v;
  hold_a_whole_pot(v);
  v.tear(0.04);
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("The wall tore"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("too thin"), std::string::npos);
  EXPECT_NE(words_in(v.frame).find("Undo the tear"), std::string::npos);
  EXPECT_FALSE(v.wheel_commands.hands.back().active) << "the hand is off the clay";
  EXPECT_FALSE(v.wheel_commands.waters.back());
  v.up(900, 300);
  v.touch("throw.restore");
  EXPECT_EQ(v.wheel_commands.restored, 1);
  v.mend();
  v.frames(1);
  EXPECT_EQ(words_in(v.frame).find("The wall tore"), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find("too thin"), std::string::npos);
  EXPECT_EQ(v.wheel_commands.restored, 1) << "and no further back";
}

TEST(Mishap, AWallThatIsThickAndToreWasOpenedTooFar) {
  Visitor v;
  v.throw_a_pot();
  v.tear(0.0025);
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("opened too far"), std::string::npos);
  EXPECT_FALSE(v.visit->control("throw.restore")) << "nothing is kept to go back to";
  v.clay.shape(50, std::vector<float>(16), std::vector<float>(16));
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("opened too far"), std::string::npos) << "it stays the reason";
}

TEST(Mishap, ATearIsToldOnceItsRowsAreThereToSayWhy) {
  Visitor v;
  v.throw_a_pot();
  v.status.feedback.torn = true;
  v.frames(1);
  EXPECT_EQ(words_in(v.frame).find("The wall tore"), std::string::npos);
  v.tear(0.0025);
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("The wall tore"), std::string::npos);
}

// The way back from a tear has just been asked for.
void go_back_from_a_tear(Visitor& v) {
  v.throw_a_pot();
  v.status.can_restore = true;
  v.tear(0.04);
  v.frames(1);
  v.touch("throw.restore");
}

TEST(Mishap, BeforeTheTearIsAsManyStepsBackAsItTakes) {
  Visitor v;
  go_back_from_a_tear(v);
  for (int n = 0; n < 90; ++n) {
    v.show();
    if (v.wheel_commands.restored == 3) v.mend();
  }
  EXPECT_EQ(v.wheel_commands.restored, 3);
}

TEST(Mishap, AVisitorWhoThrowsOnAfterATearIsNotTakenBackAnyFurther) {
  Visitor v;
  go_back_from_a_tear(v);
  v.down(900, 300);
  for (int n = 0; n < 60; ++n) {
    v.show();
  }
  EXPECT_EQ(v.wheel_commands.restored, 1);
  EXPECT_TRUE(v.wheel_commands.hands.back().active);
}

TEST(Mishap, AFreshLumpEndsTheWordsOfATearAndAFallGoesBeforeIt) {
  Visitor v;
  v.throw_a_pot();
  v.status.can_restore = true;
  v.tear(0.04);
  v.status.feedback.fallen = true;
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("It collapsed"), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find("The wall tore"), std::string::npos);
  v.status.feedback.fallen = false;
  v.frames(1);
  EXPECT_NE(words_in(v.frame).find("The wall tore"), std::string::npos);
  v.touch("throw.renew");
  EXPECT_EQ(v.wheel_commands.renewed, 1);
  v.mend();
  v.touch("throw.less");
  v.frames(1);
  EXPECT_EQ(words_in(v.frame).find("The wall tore"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::mishap_test
