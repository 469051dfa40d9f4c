#include "kiosk/visit/screens/clay_screen.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::clay_screen_test {
namespace {

using view::Key;

bool at_work(const Visitor& v) {
  return std::ranges::any_of(v.wheel_commands.hands, [](const HandInput& h) { return h.active; });
}
int pots_begun(Visitor& v) {
  int count = 0;
  for (const Request& r : v.requests()) count += std::holds_alternative<StartPot>(r);
  return count;
}

TEST(ClayScreen, AFingerOnAttractsClayPressesThatClayAtOnceAndTheShelfComesAfter) {
  Visitor v;
  v.frames(2);
  v.requests();
  const view::Camera camera = v.frame.pot->camera;
  v.wheel_commands.hands.clear();
  v.press_clay();
  EXPECT_TRUE(at_work(v)) << "no frame later";
  EXPECT_EQ(v.visit->screen(), ScreenId::clay);
  EXPECT_EQ(v.wheel_commands.ended, 1) << "of attract's script";
  EXPECT_TRUE(v.wheel_commands.waters.back()) << "wet clay gives way";
  EXPECT_NEAR(v.wheel_commands.wheels.back(), 25, 0.1);
  v.show();
  EXPECT_EQ(pots_begun(v), 0) << "it is the same pot";
  EXPECT_EQ(v.frame.pot->camera, camera) << "nothing moves under the finger";
  EXPECT_NE(words_in(v.frame).find("Shape it"), std::string::npos);
  const auto in = *camera.project({0.035, 0.1, 0});
  v.move(in.first, in.second);
  v.frames(1);
  double least = 1;
  for (const HandInput& h : v.wheel_commands.hands)
    if (h.active && h.side == SideWish::outside) least = std::min(least, h.position.x);
  EXPECT_LT(least, 0.05) << "the hand goes with the finger";
  v.up(in.first, in.second);
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::clay) << "for as long as they like";
  v.touch("clay.on");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  EXPECT_FALSE(v.wheel_commands.waters.back());
}

TEST(ClayScreen, OneTouchOfThePotsMiddleDoesNotCutItInTwo) {
  Visitor v;
  v.frames(2);
  v.press_clay();
  v.show();
  const double r = v.clay.profile().outer_at(0.1);
  const auto middle = *v.frame.pot->camera.project({0.002, 0.1, 0});
  v.move(middle.first, middle.second);
  v.frames(3);
  double least = 1;
  for (const HandInput& h : v.wheel_commands.hands)
    if (h.active && h.side == SideWish::outside) least = std::min(least, h.position.x);
  EXPECT_GT(least, 0.65 * r);
  EXPECT_LT(least, 0.9 * r) << "but it gives";
}

TEST(ClayScreen, AFingerThatGoesOnPastTheAxisHasTheHandsWithIt) {
  Visitor v;
  v.frames(2);
  v.press_clay();
  v.show();
  const view::Camera camera = v.frame.pot->camera;
  const auto hand = [&] {
    for (auto h = v.wheel_commands.hands.rbegin(); h != v.wheel_commands.hands.rend(); ++h)
      if (h->active && h->side == SideWish::outside) return h->position.x;
    return 0.0;
  };
  for (const double x : {0.04, 0.01, -0.03, -0.05}) {
    const auto [px, py] = *camera.project({x, 0.1, 0});
    v.move(px, py);
    v.frames(0.3);
    EXPECT_GT(hand() * x, 0) << x;
  }
}

TEST(ClayScreen, APotThatWasCutOffOrFellIsAFreshLumpUnderTheFinger) {
  for (const bool cut : {true, false}) {
    Visitor v;
    v.frames(2);
    v.requests();
    (cut ? v.status.feedback.cut_free : v.status.feedback.wetness) = 1;
    v.status.feedback.fallen = !cut;
    v.show();
    v.wheel_commands.hands.clear();
    v.press_clay();
    v.show();
    v.status.feedback = {};
    v.show();
    EXPECT_EQ(pots_begun(v), 1);
    EXPECT_TRUE(at_work(v));
  }
}

TEST(ClayScreen, AnArrowPressesTheClayAndEnterGoesToTheShelf) {
  Visitor v;
  v.frames(2);
  v.wheel_commands.hands.clear();
  v.key(Key::left);
  ASSERT_EQ(v.visit->screen(), ScreenId::clay);
  EXPECT_TRUE(at_work(v)) << "the first press counts";
  EXPECT_NE(words_in(v.frame).find("arrow keys"), std::string::npos);
  v.key(Key::next);
  EXPECT_EQ(v.visit->focus(), "clay.on") << "Tab leads to the buttons";
  v.key(Key::back);
  EXPECT_EQ(v.visit->focus(), "") << "and Esc to the hands";
  v.key(Key::enter);
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  Visitor direct;
  direct.key(Key::enter);
  EXPECT_EQ(direct.visit->screen(), ScreenId::choose);
}

TEST(ClayScreen, WhoMakesStrokesByButtonsPressesTheClayByOne) {
  for (bool settings::Exhibit::Screen::*const way :
       {&settings::Exhibit::Screen::spoken, &settings::Exhibit::Screen::one_switch}) {
    Visitor v;
    v.exhibit.screen.*way = true;
    v.frames(2);
    v.wheel_commands.hands.clear();
    v.down(5, 5);
    v.up(5, 5);
    v.show();
    ASSERT_EQ(v.visit->screen(), ScreenId::clay);
    EXPECT_FALSE(at_work(v));
    EXPECT_EQ(v.visit->reading().first, "clay.press");
    v.visit->activate("clay.press", v.now);
    v.frames(0.5);
    EXPECT_TRUE(at_work(v));
    v.visit->activate("clay.on", v.now);
    EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  }
}

TEST(ClayScreen, WhoWalksOffIsFollowedByAttractWithAFreshPot) {
  Visitor v;
  v.frames(2);
  v.press_clay();
  v.up(0, 0);
  v.requests();
  v.frames(v.exhibit.idle.warn_after + v.exhibit.idle.countdown + 2);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_GE(pots_begun(v), 1);
}

TEST(ClayScreen, AVisitThatEndsThereIsCountedAsThat) {
  Visitor v;
  v.frames(2);
  v.press_clay();
  v.up(0, 0);
  v.show();
  v.requests();
  v.touch("back");
  for (const Request& r : v.requests())
    if (const auto* over = std::get_if<VisitEnded>(&r)) {
      ASSERT_TRUE(over->notes);
      EXPECT_EQ(name_of(over->notes->reached), "clay");
      EXPECT_EQ(name_of(over->notes->left), "clay");
    }
}

TEST(FirstClay, AVesselThatWasBuiltIsBuiltInAttractAndAFingerThereGetsALumpToThrow) {
  Visitor v(2, nullptr, false, true);
  for (ShelfCard& card : v.shelf) {
    card.built = card.wheel;
    card.built->coil = 0.013;
    card.built->max_speed = 8.0;
  }
  // The next pot of attract.
  v.status.script_done = true;
  v.frames(12);
  const StartPot* last = nullptr;
  const auto asked = v.requests();
  for (const Request& r : asked)
    if (const auto* start = std::get_if<StartPot>(&r)) last = start;
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->script, "build");
  EXPECT_TRUE(last->built);
  EXPECT_NE(words_in(v.frame).find("built of coils"), std::string::npos);
  v.status.script_done = true;
  v.frames(2);
  EXPECT_NE(words_in(v.frame).find("Just made"), std::string::npos) << "its name is told";
  v.status.script_done = false;  // half built again
  v.show();
  v.press_clay();
  v.frames(0.5);
  ASSERT_EQ(v.visit->screen(), ScreenId::clay);
  const auto then = v.requests();
  ASSERT_FALSE(then.empty());
  const auto* fresh = std::get_if<StartPot>(&then.front());
  ASSERT_NE(fresh, nullptr);
  EXPECT_EQ(fresh->script, "");
  EXPECT_FALSE(fresh->built);
  EXPECT_GT(v.wheel_commands.wheels.back(), 8.0) << "of the scene in which it is thrown";
}

TEST(FirstClay, AVesselThatCoilsDoNotComeNearIsThrownInAttract) {
  Visitor v(2, nullptr, false, true);
  for (ShelfCard& card : v.shelf) {
    card.built = card.wheel;
    card.built->coil = 0.013;
    for (ProfilePoint& p : card.target.points) p.height *= 0.2;  // as wide as a bowl
  }
  v.status.script_done = true;
  v.frames(12);
  const auto asked = v.requests();
  const auto* last = std::get_if<StartPot>(&asked.back());
  ASSERT_NE(last, nullptr);
  EXPECT_EQ(last->script, "follow");
  EXPECT_FALSE(last->built);
}

}  // namespace
}  // namespace onggi::screens::clay_screen_test
