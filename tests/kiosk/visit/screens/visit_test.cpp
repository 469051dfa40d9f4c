#include <gtest/gtest.h>

#include <algorithm>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::visit_test {
namespace {

using view::Key;

template <class T>
int count(const std::vector<Request>& all) {
  return static_cast<int>(std::count_if(
      all.begin(), all.end(), [](const Request& r) { return std::holds_alternative<T>(r); }));
}

TEST(Visit, AttractThrowsWithAPottersHandsWhichAreLiftedWhenSomebodyBegins) {
  Visitor v;
  v.frames(1);
  EXPECT_EQ(std::get<StartPot>(v.requests().front()).script, "");
  v.frames(8);
  ASSERT_FALSE(v.wheel_commands.wheels.empty());
  EXPECT_GT(v.wheel_commands.wheels.back(), 10.0);
  ASSERT_GE(v.wheel_commands.waters.size(), 2u);
  EXPECT_TRUE(v.wheel_commands.waters.front());
  EXPECT_TRUE(std::ranges::any_of(v.wheel_commands.hands, &HandInput::active));
  v.wheel_commands.hands.clear();
  v.touch("attract.begin");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  ASSERT_GE(v.wheel_commands.hands.size(), 2u);
  EXPECT_FALSE(v.wheel_commands.hands[v.wheel_commands.hands.size() - 2].active);
  EXPECT_FALSE(v.wheel_commands.hands.back().active);
}

TEST(Visit, WhereClayIsKeptAttractThrowsAPotByScriptAndNamesItAtTheEnd) {
  Visitor v(9, nullptr, false, true);
  v.frames(1);
  const auto asked = v.requests();
  ASSERT_EQ(count<StartPot>(asked), 1);
  EXPECT_TRUE(std::get<StartPot>(asked.front()).scripted);
  EXPECT_EQ(words_in(v.frame).find("Panathenaic"), std::string::npos);
  v.status.script_done = true;
  v.frames(2);
  EXPECT_NE(words_in(v.frame).find("Panathenaic"), std::string::npos);
  v.frames(8);
  const auto next = v.requests();
  ASSERT_EQ(count<StartPot>(next), 1);
  EXPECT_EQ(std::get<StartPot>(next.front()).card, 1);
}

TEST(Visit, AttractShowsWhatTheClayOfAVesselDoesWithALineOfWordsAndNoName) {
  Visitor v(9, nullptr, false, true);
  for (ShelfCard& card : v.shelf) card.wheel.shown = {"follow", "collapse"};
  v.frames(1);
  EXPECT_EQ(std::get<StartPot>(v.requests().front()).script, "follow");
  v.status.script_done = true;
  v.frames(8);
  const auto next = v.requests();
  ASSERT_EQ(count<StartPot>(next), 1);
  EXPECT_EQ(std::get<StartPot>(next.front()).script, "collapse");
  EXPECT_NE(words_in(v.frame).find("the pot collapses"), std::string::npos) << words_in(v.frame);
  v.status.script_done = true;
  v.frames(2);
  EXPECT_EQ(words_in(v.frame).find("Just made"), std::string::npos);
}

TEST(Visit, TheFirstTouchCountsWhereverItLands) {
  for (const auto& [x, y] :
       {std::pair(1200.f, 10.f), std::pair(640.f, 360.f), std::pair(5.f, 5.f)}) {
    Visitor v;
    v.down(x, y);
    EXPECT_EQ(v.visit->screen(), ScreenId::choose);
    v.up(x, y);
    v.show();
    EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  }
}

TEST(Visit, TheGlobeInAttractChangesTheLanguageAndBeginsNoVisit) {
  Visitor v;
  v.speak("ko");
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(v.visit->language(), "ko");
  EXPECT_NE(words_in(v.frame).find("시작하기"), std::string::npos);
}

TEST(Visit, LanguageIsTwoTouchesAwayOnEveryScreen) {
  Visitor v;
  const auto twice = [&] {
    v.speak("ko");
    EXPECT_EQ(v.visit->language(), "ko");
    v.speak("en");
    EXPECT_EQ(v.visit->language(), "en");
  };
  twice();
  v.begin();
  twice();
  v.touch("choose.card.1");
  twice();
  v.touch("choose.throw");
  twice();
  v.touch("throw.done");
  twice();
  v.touch("result.keep");
  twice();
  v.visit->fail({"a", "b", "c"});
  v.show();
  twice();
}

TEST(Visit, AWholeVisitByTouchAsksForOneKeepsakeAndEndsForgotten) {
  Visitor v;
  v.make_result();
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  v.requests();
  v.touch("result.keep");
  ASSERT_EQ(v.visit->screen(), ScreenId::keepsake);
  const auto asked = v.requests();
  ASSERT_EQ(count<MakeKeepsake>(asked), 1);
  const auto& keepsake = std::get<MakeKeepsake>(asked.front());
  EXPECT_EQ(keepsake.card, 0);
  EXPECT_GE(keepsake.score.stars, 1);
  EXPECT_FALSE(keepsake.made.points.empty());
  v.visit->show_postcard(42);
  v.visit->keepsake_kept("moon jar 14:15");
  v.show();
  EXPECT_NE(words_in(v.frame).find("moon jar 14:15"), std::string::npos);
  v.touch("keepsake.done");
  v.touch("keepsake.done");  // thanks
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(count<VisitEnded>(v.requests()), 1);
}

TEST(Visit, GoingBackFromTheKeepsakeDoesNotKeepThePotTwice) {
  Visitor v;
  v.make_result();
  v.requests();
  v.touch("result.keep");
  v.touch("back");
  v.touch("result.keep");
  EXPECT_EQ(count<MakeKeepsake>(v.requests()), 1);
}

TEST(Visit, APostcardThatCouldNotBeKeptIsSaidKindly) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  v.visit->keepsake_failed({"/full/disk", "No space is left on the device.", "Make room."});
  v.show();
  EXPECT_NE(words_in(v.frame).find("Sorry"), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find("/full/disk"), std::string::npos);
}

TEST(Visit, APostcardThatComesAfterTheVisitorHasGoneIsNotShown) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  v.touch("keepsake.done");
  v.touch("keepsake.done");  // they do not wait for its name
  v.visit->show_postcard(42);
  v.visit->keepsake_kept("someone's");
  v.make_result();
  v.touch("result.keep");
  EXPECT_EQ(words_in(v.frame).find("someone's"), std::string::npos);
  for (const view::Item& item : v.frame.items)
    EXPECT_FALSE(std::holds_alternative<view::Picture>(item));
}

TEST(Visit, AStrokeOrARenewedLumpCanBeTakenBackWhileThereIsOne) {
  Visitor v;
  v.throw_a_pot();
  v.touch("throw.renew");
  EXPECT_EQ(v.wheel_commands.renewed, 1);
  EXPECT_FALSE(v.visit->control("throw.restore"));
  v.status.can_restore = true;
  v.show();
  v.touch("throw.restore");
  EXPECT_EQ(v.wheel_commands.restored, 1);
  EXPECT_EQ(v.wheel_commands.renewed, 1);
}

TEST(Visit, TheWheelTurnsByItselfAndCanBeMadeSlowerUntilItStands) {
  Visitor v;
  v.throw_a_pot();
  ASSERT_FALSE(v.wheel_commands.wheels.empty());
  EXPECT_NEAR(v.wheel_commands.wheels.back(), 25, 0.1);
  for (int i = 0; i < 20; ++i) v.touch("throw.slower");
  EXPECT_EQ(v.wheel_commands.wheels.back(), 0);
  v.touch("throw.less");
  v.frames(3);
  EXPECT_NE(words_in(v.frame).find("The wheel has stopped"), std::string::npos);
  for (int i = 0; i < 30; ++i) v.touch("throw.faster");
  EXPECT_NEAR(v.wheel_commands.wheels.back(), 31.4, 1e-9);
}

TEST(Visit, AVisitorSetsHowMuchForceIsFeltDownToOffAndTheNextBeginsWithAll) {
  Visitor v;
  v.throw_a_pot();
  v.touch("throw.wheel");
  EXPECT_FALSE(v.visit->control("throw.softer")) << "nothing pushes";
  v.touch("throw.less");
  v.news.device_in_use(device::DeviceKind::onggi_hid, true);
  v.show();
  EXPECT_EQ(v.visit->force_share(), 1.0);
  EXPECT_NE(words_in(v.frame).find("you feel the clay"), std::string::npos);
  v.touch("throw.softer");
  EXPECT_EQ(v.visit->force_share(), 0.75);
  EXPECT_NE(words_in(v.frame).find("75"), std::string::npos);
  for (int i = 0; i < 5; ++i) v.touch("throw.softer");
  EXPECT_EQ(v.visit->force_share(), 0.0);
  EXPECT_NE(words_in(v.frame).find("off"), std::string::npos);
  v.speak("ko");
  EXPECT_NE(words_in(v.frame).find("끔"), std::string::npos);
  v.touch("throw.stronger");
  EXPECT_EQ(v.visit->force_share(), 0.25);
  v.frames(600);  // and goes
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(v.visit->force_share(), 1.0);
}

TEST(Visit, WaterIsASwitchForATapAndASpongeForALongPress) {
  Visitor v;
  v.throw_a_pot();
  v.touch("throw.water");
  EXPECT_TRUE(v.wheel_commands.waters.back());
  v.touch("throw.water");
  EXPECT_FALSE(v.wheel_commands.waters.back());
  const auto rect = *v.visit->control("throw.water");
  v.down(rect.x + 5, rect.y + 5);
  v.frames(1);
  EXPECT_TRUE(v.wheel_commands.waters.back());
  v.up(rect.x + 5, rect.y + 5);
  EXPECT_FALSE(v.wheel_commands.waters.back());
}

TEST(Visit, LeftHandsGetTheMirroredPageAndWheel) {
  Visitor right;
  right.throw_a_pot();
  Visitor left;
  left.exhibit.screen.left_handed = true;
  left.throw_a_pot();
  EXPECT_LT(left.wheel_commands.wheels.back(), 0);
  EXPECT_LT(right.visit->control("throw.done")->x, 640);
  EXPECT_GT(left.visit->control("throw.done")->x, 640);
}

TEST(Visit, AFaultIsSaidInWordsAndAnyTouchGoesOn) {
  Visitor v;
  v.throw_a_pot();
  v.visit->fail({"scene", "The scene could not be made.", "Look in the log."});
  v.show();
  ASSERT_EQ(v.visit->screen(), ScreenId::fault);
  EXPECT_NE(words_in(v.frame).find("It was not your fault"), std::string::npos);
  v.down(1000, 200);
  v.up(1000, 200);
  v.show();
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Visit, AnEmptyShelfIsSaidAndIsNoDeadEnd) {
  Visitor v(0);
  v.down(600, 300);
  v.show();
  EXPECT_NE(words_in(v.frame).find("No vessel is ready"), std::string::npos);
  v.up(600, 300);
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Visit, ScreensCrossFadeAndReducedMotionStillsThat) {
  Visitor v;
  v.frames(1);
  EXPECT_EQ(v.frame.fade, 0);
  const auto serial = v.frame.screen_serial;
  v.down(600, 300);
  v.show();
  EXPECT_NE(v.frame.screen_serial, serial);
  EXPECT_GT(v.frame.fade, 0.5f);
  v.frames(0.4);
  EXPECT_EQ(v.frame.fade, 0);
  v.exhibit.screen.reduced_motion = true;
  v.up(600, 300);
  v.touch("choose.card.0");
  EXPECT_EQ(v.frame.fade, 0);
}

TEST(Visit, EveryVesselOfALongShelfCanBeReached) {
  Visitor v(30);
  v.begin();
  std::vector<bool> met(30, false);
  for (int page = 0; page < 40; ++page) {
    for (int i = 0; i < 30; ++i)
      if (v.visit->control("choose.card." + std::to_string(i)))
        met[static_cast<std::size_t>(i)] = true;
    if (!v.visit->control("choose.next")) break;
    v.touch("choose.next");
    v.frames(1.5);
  }
  EXPECT_EQ(std::count(met.begin(), met.end(), true), 30);
  v.touch("choose.previous");
  EXPECT_EQ(v.visit->screen(), ScreenId::choose);
}

TEST(Visit, TheWholeVisitGoesByKeyboardAlone) {
  Visitor v;
  v.key(Key::enter);
  ASSERT_EQ(v.visit->screen(), ScreenId::choose);
  ASSERT_TRUE(v.key_to("choose.card.2"));
  ASSERT_TRUE(v.key_to("choose.throw"));
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  v.show();
  v.key(Key::left);
  ASSERT_FALSE(v.wheel_commands.hands.empty());
  EXPECT_TRUE(v.wheel_commands.hands.back().active);
  // Of a thick wall the hand inside stays, the one outside comes.
  const auto outside = [&] {
    return std::ranges::find(v.wheel_commands.hands.rbegin(), v.wheel_commands.hands.rend(),
                             SideWish::outside, &HandInput::side)
        ->position.x;
  };
  const double begun = outside();
  v.key(Key::left);
  EXPECT_LT(outside(), begun);
  const double low = v.wheel_commands.hands.back().position.y;
  v.key(Key::up);
  EXPECT_GT(v.wheel_commands.hands.back().position.y, low);
  v.key(Key::enter);
  ASSERT_TRUE(v.key_to("throw.inside"));
  ASSERT_TRUE(v.key_to("throw.done"));
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  ASSERT_TRUE(v.key_to("result.keep"));
  ASSERT_EQ(v.visit->screen(), ScreenId::keepsake);
  v.visit->keepsake_kept("quiet blue heron");
  v.frames(0.5);
  ASSERT_TRUE(v.key_to("keepsake.done"));
  v.frames(0.5);
  ASSERT_TRUE(v.key_to("keepsake.done"));  // thanks
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Visit, BackLeavesEveryScreen) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  std::vector<ScreenId> way;
  for (int i = 0; i < 6 && v.visit->screen() != ScreenId::attract; ++i) {
    v.key(Key::back);
    way.push_back(v.visit->screen());
  }
  EXPECT_EQ(way, (std::vector{ScreenId::result, ScreenId::throwing, ScreenId::choose,
                              ScreenId::attract}));
  v.visit->fail({"a", "b", "c"});
  v.show();
  v.key(Key::back);
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
}

TEST(Visit, HelpOpensOverEveryScreenAndGoesAway) {
  Visitor v;
  const auto look = [&] {
    const ScreenId before = v.visit->screen();
    v.key(Key::help);
    EXPECT_NE(words_in(v.frame).find("Continue"), std::string::npos);
    EXPECT_EQ(words_in(v.frame).find('['), std::string::npos);
    v.key(Key::back);
    EXPECT_EQ(words_in(v.frame).find("Continue"), std::string::npos);
    v.touch("help");
    v.touch("help.close");
    EXPECT_EQ(v.visit->screen(), before);
  };
  look();
  v.begin();
  look();
  v.touch("choose.card.1");
  look();
  v.touch("choose.throw");
  look();
  v.touch("throw.done");
  look();
  v.touch("result.keep");
  look();
}

}  // namespace
}  // namespace onggi::screens::visit_test
