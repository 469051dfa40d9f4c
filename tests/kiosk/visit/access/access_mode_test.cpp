#include "kiosk/visit/access/access_mode.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::access::access_mode_test {
namespace {

using screens::ScreenId;
using screens::Visitor;
using view::InputEvent;
using view::Key;
using Kind = InputEvent::Kind;

constexpr double kHold = 3.0, kPxPerMm = 2.4;

/// Somebody who goes through the assistant.
struct Aided {
  Aided() : v(9, nullptr, true), assistant(kHold) {}
  void begin_by_one_switch() {
    v.exhibit.screen.one_switch = true;
    wait(0.1);
    event(Kind::pointer_down, 600, 300), event(Kind::pointer_up, 600, 300);
    wait(0.2);
  }
  void wait(double seconds) {
    for (const double until = v.now + seconds; v.now < until - 1e-9;) {
      v.show();
      assistant.look(*v.visit, v.frame, v.now);
      if (auto one = assistant.take()) {
        if (quick) assistant.ended(one->id);
        said.push_back(one->text);
      }
    }
  }
  void event(Kind kind, float x, float y, Key key = Key::none) {
    InputEvent e;
    e.kind = kind;
    e.x = x;
    e.y = y;
    e.key = key;
    e.glass = kind < Kind::key_down;
    assistant.input(e, *v.visit, kPxPerMm, v.now);
  }
  void hold_a_key(double seconds) {
    event(Kind::key_down, 0, 0, Key::enter);
    wait(seconds);
    event(Kind::key_up, 0, 0, Key::enter);
    wait(0.2);
  }
  void tap(const std::string& control) {
    const auto at = v.visit->control(control);
    ASSERT_TRUE(at) << control;
    event(Kind::pointer_down, at->x + at->w / 2, at->y + at->h / 2);
    wait(0.1);
    event(Kind::pointer_up, at->x + at->w / 2, at->y + at->h / 2);
    wait(0.2);
  }
  Visitor v;
  AccessMode assistant;
  std::vector<std::string> said;
  bool quick = true;  ///< The voice has said each at once.
};

TEST(AccessMode, AKeyOrAFingerThatIsHeldForThreeSecondsHasTheScreenReadAndForSixIsOneSwitch) {
  for (const bool key : {true, false})
    for (const double seconds : {2.7, 3.3, 6.3}) {
      Aided a;
      if (key) {
        a.hold_a_key(seconds);
      } else {
        a.event(Kind::pointer_down, 600, 300);
        a.wait(seconds);
        a.event(Kind::pointer_up, 600, 300);
        a.wait(0.2);
      }
      EXPECT_EQ(a.v.visit->shown_on().spoken, seconds > 3);
      EXPECT_EQ(a.v.visit->shown_on().one_switch, seconds > 6);
      EXPECT_EQ(a.v.visit->screen(), ScreenId::choose);
      EXPECT_EQ(!a.said.empty(), seconds > 3);
    }
}

TEST(AccessMode, WhoHoldsOnIsToldFirstThatHoldingOnBringsOneSwitch) {
  const auto language = *content::Language::read("content/languages/en.toml");
  const std::string hold_on = language.say("access.hold_on");
  Aided a;
  a.event(Kind::key_down, 0, 0, Key::enter);
  a.wait(2.7);
  EXPECT_TRUE(a.said.empty());
  a.wait(0.6);
  ASSERT_FALSE(a.said.empty());
  EXPECT_TRUE(a.said[0].starts_with(hold_on + " " + language.say("access.begun"))) << a.said[0];
  a.event(Kind::key_up, 0, 0, Key::enter);
  a.wait(6);
  a.said.clear();
  a.event(Kind::key_down, 0, 0, Key::enter);
  a.wait(3.3);
  EXPECT_NE(std::find(a.said.begin(), a.said.end(), hold_on), a.said.end())
      << "also where it is read aloud already";
}

TEST(AccessMode, AFingerThatGoesElsewhereMeanwhileHasAskedForNothing) {
  Aided a;
  a.event(Kind::pointer_down, 600, 300);
  a.wait(1);
  a.event(Kind::pointer_move, 700, 300);
  a.wait(6);
  EXPECT_FALSE(a.v.visit->shown_on().spoken);
}

TEST(AccessMode, WhereTheExhibitDoesNotWantThatGestureThereIsNone) {
  Aided a;
  a.assistant = AccessMode(0);
  a.hold_a_key(10);
  EXPECT_FALSE(a.v.visit->shown_on().spoken);
}

TEST(AccessMode, AFingerExploresAndASecondTouchChooses) {
  Aided a;
  a.hold_a_key(3.3);
  a.said.clear();
  a.tap("choose.card.2");
  EXPECT_EQ(a.v.visit->focus(), "choose.card.2");
  EXPECT_TRUE(a.v.visit->control("choose.card.2")) << "it is not opened";
  ASSERT_FALSE(a.said.empty());
  const auto at = a.v.visit->control("choose.card.1");
  a.event(Kind::pointer_down, at->x + 5, at->y + 5);
  const auto next = a.v.visit->control("choose.card.2");
  a.event(Kind::pointer_move, next->x + 5, next->y + 5);
  EXPECT_EQ(a.v.visit->focus(), "choose.card.2");
  a.event(Kind::pointer_up, next->x + 5, next->y + 5);
  a.wait(0.2);
  EXPECT_TRUE(a.v.visit->control("choose.card.2")) << "a finger that passed chose nothing";
  a.tap("choose.card.2");
  EXPECT_FALSE(a.v.visit->control("choose.card.2"));
  EXPECT_TRUE(a.v.visit->control("choose.throw"));
}

TEST(AccessMode, TheKeyAndTheCornerSayWhereOneIsAndAtTheWheelHowThePotDiffers) {
  Aided a;
  a.hold_a_key(3.3);
  for (const bool key : {true, false}) {
    a.said.clear();
    key ? a.event(Kind::key_down, 0, 0, Key::tell) : a.event(Kind::pointer_down, 3, 3);
    a.wait(0.3);
    a.event(Kind::pointer_up, 3, 3);
    ASSERT_EQ(a.said.size(), 1u);
    EXPECT_NE(a.said[0].find("Choose a vessel"), std::string::npos);
  }
  a.tap("choose.card.0"), a.tap("choose.card.0");
  a.tap("choose.throw"), a.tap("choose.throw");
  a.wait(2);
  for (const bool key : {true, false}) {
    a.said.clear();
    key ? a.event(Kind::key_down, 0, 0, Key::tell) : a.event(Kind::pointer_down, 3, 3);
    a.wait(0.3);
    a.event(Kind::pointer_up, 3, 3);
    ASSERT_FALSE(a.said.empty());
    EXPECT_NE(a.said[0].find("mm too"), std::string::npos) << a.said[0];
  }
}

TEST(AccessMode, HowThePotDiffersIsSungOnceItHasBeenSaid) {
  Aided a;
  a.hold_a_key(3.3);
  a.v.visit->activate("choose.card.0", a.v.now), a.wait(0.2);
  a.v.visit->activate("choose.throw", a.v.now), a.wait(8);
  EXPECT_FALSE(a.assistant.sings());
  a.event(Kind::key_down, 0, 0, Key::tell);
  a.wait(0.3);
  EXPECT_TRUE(a.assistant.sings()) << "the voice of this test is done at once";
  EXPECT_FALSE(a.assistant.sings()) << "and once";
  a.quick = false;
  a.event(Kind::key_up, 0, 0, Key::tell), a.event(Kind::key_down, 0, 0, Key::tell);
  a.wait(0.3);
  EXPECT_FALSE(a.assistant.sings()) << "not while it is being said";
  a.wait(8);
  EXPECT_TRUE(a.assistant.sings());
}

TEST(AccessMode, WithOneSwitchATouchAnywhereAndAnyKeyAreTheSame) {
  Aided a;
  a.hold_a_key(6.3);
  ASSERT_TRUE(a.v.visit->shown_on().one_switch);
  a.wait(0.1);
  ASSERT_GT(a.assistant.scan().shown().size(), 1u);
  a.event(Kind::pointer_down, 1200, 5);
  EXPECT_TRUE(a.assistant.scan().in_a_row());
  a.wait(0.3);
  const std::string first = a.assistant.scan().shown().front();
  a.event(Kind::key_down, 0, 0, Key::other);
  a.wait(0.3);
  EXPECT_FALSE(a.v.visit->control(first)) << "it was opened";
}

TEST(AccessMode, WhatTheSwitchStandsOnIsRungRoundInDarkAndLight) {
  Aided a;
  a.hold_a_key(6.3);
  a.wait(0.1);
  const auto first = a.v.visit->control(a.assistant.scan().shown().front());
  ASSERT_TRUE(first);
  int rings = 0;
  for (const view::Item& item : a.v.frame.items)
    if (const auto* box = std::get_if<view::Box>(&item))
      rings += box->rect.x < first->x && box->rect.y < first->y && box->border > 0;
  EXPECT_GE(rings, 3);
}

TEST(AccessMode, AFingerThatIsHeldOnTheClayWorksAndHasNothingRead) {
  Aided a;
  a.v.frames(2);
  const auto at = *a.v.frame.pot->camera.project({0.05, 0.1, 0});
  for (int n = 0; n < 2; ++n) {  // from attract, then on the clay's own screen
    a.event(Kind::pointer_down, at.first, at.second);
    a.wait(7);
    a.event(Kind::pointer_up, at.first, at.second);
    EXPECT_EQ(a.v.visit->screen(), ScreenId::clay);
    EXPECT_FALSE(a.v.visit->shown_on().spoken);
  }
  a.event(Kind::pointer_down, 5, 5);
  a.wait(3.3);
  EXPECT_TRUE(a.v.visit->shown_on().spoken) << "beside it";
}

TEST(AccessMode, ATouchOnItsOwnRowTurnsTheOneSwitchOff) {
  Aided a;
  a.begin_by_one_switch();
  a.v.visit->activate("comfort", a.v.now);
  a.wait(0.2);
  const auto row = a.v.visit->control("comfort.one_switch");
  ASSERT_TRUE(row);
  a.event(Kind::pointer_down, row->x + 5, row->y + 5);
  a.event(Kind::pointer_up, row->x + 5, row->y + 5);
  a.wait(0.2);
  EXPECT_FALSE(a.v.visit->shown_on().one_switch);
  EXPECT_FALSE(a.v.visit->shown_on().left_handed) << "and picks nothing else";
}

TEST(AccessMode, APressOverTheWarningStaysAndPressesNothingElse) {
  Aided a;
  a.begin_by_one_switch();
  a.v.frames(a.v.exhibit.idle.warn_after + 62);
  a.wait(0.1);
  ASSERT_TRUE(a.v.visit->idle_warning());
  a.event(Kind::pointer_down, 3, 3);
  a.wait(0.2);
  EXPECT_FALSE(a.v.visit->idle_warning());
  EXPECT_EQ(a.v.visit->screen(), ScreenId::clay);
  EXPECT_TRUE(a.v.visit->control("clay.on"));
}

TEST(AccessMode, WithoutEitherEverythingGoesToTheVisitAsItCame) {
  Aided a;
  a.event(Kind::pointer_down, 600, 300), a.event(Kind::pointer_up, 600, 300);
  a.wait(0.2);
  a.tap("choose.card.0");
  EXPECT_TRUE(a.v.visit->control("choose.throw")) << "one touch opens";
  EXPECT_TRUE(a.said.empty());
}

}  // namespace
}  // namespace onggi::access::access_mode_test
