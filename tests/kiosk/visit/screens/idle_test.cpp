#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::idle_test {
namespace {

using view::Key;

TEST(Idle, TheWarningIsSeenForAtLeastTwentySecondsAndThenNothingOfTheVisitorIsLeft) {
  Visitor v;
  v.exhibit.idle.countdown = 5;  // Even if an exhibit says less.
  v.make_result();
  v.touch("result.keep");
  v.visit->show_postcard(42);
  v.speak("ko");
  v.requests();
  v.frames(v.exhibit.idle.result_after - 0.6);
  ASSERT_TRUE(v.visit->idle_warning());
  double seen = 0;
  while (v.visit->screen() != ScreenId::attract && seen < 100) {
    EXPECT_TRUE(v.visit->idle_warning());
    v.frames(0.5);
    seen += 0.5;
  }
  EXPECT_GE(seen, 19.0);
  EXPECT_LT(seen, 22.0);
  bool forgotten = false;
  for (const Request& r : v.requests())
    forgotten = forgotten || std::holds_alternative<VisitEnded>(r);
  EXPECT_TRUE(forgotten);
  EXPECT_EQ(v.visit->language(), "en");
  for (const view::Item& item : v.frame.items)
    EXPECT_FALSE(std::holds_alternative<view::Picture>(item));
}

TEST(Idle, TheCountdownCountsInWords) {
  Visitor v;
  v.throw_a_pot();
  v.frames(v.exhibit.idle.warn_after + 0.2);
  ASSERT_TRUE(v.visit->idle_warning());
  EXPECT_NE(words_in(v.frame).find("goodbye in 25 s"), std::string::npos) << words_in(v.frame);
  v.frames(10);
  EXPECT_NE(words_in(v.frame).find("goodbye in 15 s"), std::string::npos) << words_in(v.frame);
}

TEST(Idle, AnyInputExtendsItAnyNumberOfTimes) {
  Visitor v;
  v.throw_a_pot();
  for (int time = 0; time < 12; ++time) {
    v.frames(v.exhibit.idle.warn_after + 15);
    ASSERT_TRUE(v.visit->idle_warning());
    switch (time % 4) {
      case 0:
        v.down(1000, 300), v.up(1000, 300);
        break;
      case 1:
        v.move(20, 20);
        break;
      case 2:
        v.key(Key::up);
        break;
      case 3:
        v.status.hands.hand[0].active = true;
        v.status.hands.hand[0].position.x += 0.02;
        v.show();
        v.status.hands.hand[0].active = false;
        break;
    }
    v.show();
    EXPECT_FALSE(v.visit->idle_warning()) << time;
    EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  }
}

TEST(Idle, ATouchThatExtendsPressesNothingBehindTheWarning) {
  Visitor v;
  v.throw_a_pot();
  v.touch_clay();
  const auto done = *v.visit->control("throw.done");
  v.frames(v.exhibit.idle.warn_after + 1);
  v.down(done.x + 5, done.y + 5);
  v.show();
  v.up(done.x + 5, done.y + 5);
  v.show();
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
}

TEST(Idle, AttractNeverWarns) {
  Visitor v;
  v.frames(400);
  EXPECT_FALSE(v.visit->idle_warning());
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Idle, EveryOtherScreenFindsItsWayHomeAlone) {
  for (int stop = 0; stop < 4; ++stop) {
    Visitor v;
    v.down(600, 300);
    v.up(600, 300);
    v.show();
    if (stop > 0) v.touch("choose.card.0");
    if (stop > 1) v.touch("choose.throw");
    if (stop > 2) v.visit->fail({"a", "b", "c"});
    v.frames(v.exhibit.idle.warn_after + v.exhibit.idle.countdown + 1);
    EXPECT_EQ(v.visit->screen(), ScreenId::attract) << stop;
  }
}

}  // namespace
}  // namespace onggi::screens::idle_test
