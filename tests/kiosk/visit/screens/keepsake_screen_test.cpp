#include "kiosk/visit/screens/keepsake_screen.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::keepsake_screen_test {
namespace {

bool says(const Visitor& v, const std::string& words) {
  return words_in(v.frame).find(words) != std::string::npos;
}

struct Keeper : Visitor {
  Keeper() {
    make_result();
    touch("result.keep");
    visit->keepsake_kept("quiet blue heron");
    show();
    touch("keepsake.done");
    frames(0.5);
  }
};

TEST(KeepsakeScreen, WhoHasFinishedIsThankedAndReadsTheNameOnceMore) {
  Keeper v;
  ASSERT_EQ(v.visit->screen(), ScreenId::keepsake);
  EXPECT_TRUE(says(v, "Thank you"));
  EXPECT_TRUE(says(v, "quiet blue heron"));
  EXPECT_TRUE(says(v, "desk")) << "where to ask for it";
  v.touch("back");
  v.show();
  EXPECT_FALSE(says(v, "Thank you"));
  EXPECT_TRUE(says(v, "quiet blue heron"));
}

TEST(KeepsakeScreen, AnyTouchEndsTheThanksAndSoDoesTime) {
  Keeper touched;
  touched.down(900, 300);
  touched.up(900, 300);
  touched.show();
  EXPECT_EQ(touched.visit->screen(), ScreenId::attract);

  Keeper pressed;
  pressed.touch("keepsake.done");
  EXPECT_EQ(pressed.visit->screen(), ScreenId::attract);

  Keeper waiting;
  waiting.frames(8);
  EXPECT_EQ(waiting.visit->screen(), ScreenId::keepsake);
  waiting.frames(3);
  EXPECT_EQ(waiting.visit->screen(), ScreenId::attract);
}

TEST(KeepsakeScreen, TheThanksStandLongerForWhoHearsThem) {
  for (const bool spoken : {false, true}) {
    Visitor v;
    v.exhibit.screen.spoken = spoken;
    v.make_result();
    v.touch("result.keep");
    v.visit->keepsake_kept("quiet blue heron");
    v.show();
    v.touch("keepsake.done");
    v.frames(15);
    EXPECT_EQ(v.visit->screen(), spoken ? ScreenId::keepsake : ScreenId::attract);
  }
}

TEST(KeepsakeScreen, WithoutAPotThatIsKeptThereIsNoNameToTell) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  v.visit->keepsake_failed({"the disk", "It is full.", "Make room."});
  v.touch("keepsake.done");
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

// A quick visitor never read the name by which the desk finds the postcard.
TEST(KeepsakeScreen, WhoFinishesBeforeThePotIsKeptIsThankedOnceTheNameIsThere) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  v.touch("keepsake.done");
  v.frames(20);
  ASSERT_EQ(v.visit->screen(), ScreenId::keepsake);
  v.visit->keepsake_kept("quiet blue heron");
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Thank you"));
  EXPECT_TRUE(says(v, "quiet blue heron"));
  v.frames(11);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(KeepsakeScreen, WhoPressesTwiceGoesAtOnceAndWhoCouldNotBeServedIsToldSo) {
  Visitor insists, unlucky;
  for (Visitor* v : {&insists, &unlucky}) {
    v->make_result();
    v->touch("result.keep");
    v->touch("keepsake.done");
  }
  insists.touch("keepsake.done");
  EXPECT_EQ(insists.visit->screen(), ScreenId::attract);
  unlucky.visit->keepsake_failed({"the disk", "It is full.", "Make room."});
  unlucky.frames(0.5);
  EXPECT_EQ(unlucky.visit->screen(), ScreenId::keepsake);
  EXPECT_TRUE(says(unlucky, "Sorry"));
}

}  // namespace
}  // namespace onggi::screens::keepsake_screen_test
