#include "kiosk/visit/screens/comfort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/layout.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::comfort_test {
namespace {

using view::Key;

constexpr std::pair<int, int> kPortrait{1080, 1920};

void choose_all(Visitor& v) {
  v.touch("comfort");
  for (const Comfort::Choice& choice : Comfort::kChoices) {
    v.touch(std::string("comfort.") + choice.name);
    EXPECT_TRUE(v.visit->shown_on().*choice.of) << choice.name;
  }
  v.touch("comfort.close");
}

Visitor portrait(int vessels) {
  Visitor v(vessels);
  std::tie(v.width, v.height) = kPortrait;
  v.show();
  return v;
}

/// Everything that a visitor sees and the wheel is told in attract, until its first pot is done.
struct Seen {
  std::vector<view::Item> items;
  view::Camera camera;
  std::string language;
  std::vector<std::pair<std::string, view::Rect>> controls;
};
Seen attract(Visitor& v) {
  v.status.script_done = true;
  v.frames(3);
  return {v.frame.items, v.frame.pot->camera, v.visit->language(), v.visit->controls()};
}

TEST(Comfort, NothingOfWhatAVisitorChoseIsLeftInAttractOrForTheNext) {
  Visitor untouched = portrait(1);
  const Seen before = attract(untouched);
  for (const bool left_alone : {false, true}) {
    Visitor v = portrait(1);
    v.touch("comfort");
    v.touch("comfort.close");
    choose_all(v);
    v.speak("ko");
    if (left_alone)
      v.frames(v.exhibit.idle.warn_after + v.exhibit.idle.countdown +
               50 * v.exhibit.screen.scan_seconds + 1);  // one switch has its time
    else
      v.touch("back");
    ASSERT_EQ(v.visit->screen(), ScreenId::attract);
    const Seen after = attract(v);
    EXPECT_EQ(after.items, before.items);
    EXPECT_EQ(after.camera, before.camera);
    EXPECT_EQ(after.language, before.language);
    EXPECT_EQ(after.controls, before.controls);
    v.throw_a_pot();
    v.frames(2);
    for (const Comfort::Choice& choice : Comfort::kChoices)
      EXPECT_FALSE(v.visit->shown_on().*choice.of) << choice.name;
    EXPECT_GT(v.wheel_commands.wheels.back(), 0);
  }
}

TEST(Comfort, ALanguageThatSomebodyTriedInAttractGoesBackByItself) {
  Visitor v;
  v.speak("ko");
  EXPECT_EQ(v.visit->language(), "ko");
  v.frames(70);
  EXPECT_EQ(v.visit->language(), "en");
}

TEST(Comfort, WhatTheExhibitHasIsWhereAVisitorBegins) {
  Visitor v;
  v.exhibit.screen.left_handed = true;
  v.show();
  v.touch("comfort");
  EXPECT_TRUE(v.visit->shown_on().left_handed);
  v.touch("comfort.left_handed");
  EXPECT_FALSE(v.visit->shown_on().left_handed);
  v.touch("comfort.close");
  v.touch("back");
  EXPECT_TRUE(v.visit->shown_on().left_handed);
}

TEST(Comfort, IsOneTouchAndOneKeyAwayOnEveryScreenAndOverTheWarning) {
  Visitor v(3, nullptr, true);
  int screens = 0;
  walk(v, [&](const std::string& name) {
    if (name.find("comfort") != std::string::npos || name == "attract" || name == "idle") return;
    ++screens;
    ASSERT_TRUE(v.visit->control("comfort")) << name;
    // Over these pages the key leads to another page, not back.
    if (name.find("help") != std::string::npos || name.find("language") != std::string::npos ||
        name == "leaving")
      return;
    v.key(Key::comfort);
    EXPECT_TRUE(v.visit->control("comfort.close")) << name;
    v.key(Key::comfort);
    EXPECT_FALSE(v.visit->control("comfort.close")) << name;
  });
  EXPECT_GE(screens, 12);
  Visitor idle;
  idle.throw_a_pot();
  idle.frames(idle.exhibit.idle.warn_after + 1);
  ASSERT_TRUE(idle.visit->idle_warning());
  idle.touch("comfort");
  EXPECT_FALSE(idle.visit->idle_warning());
  EXPECT_TRUE(idle.visit->control("comfort.close"));
}

TEST(Comfort, AskedForInAttractItBeginsTheVisit) {
  for (const bool by_key : {false, true}) {
    Visitor v;
    by_key ? v.key(Key::comfort) : v.touch("comfort");
    EXPECT_TRUE(v.visit->control("comfort.close"));
    EXPECT_EQ(v.visit->screen(), ScreenId::choose);
  }
}

TEST(Comfort, ArrowsAndEnterReachEverySwitchAndBackLeaves) {
  Visitor v = portrait(9);
  v.key(Key::comfort);
  for (const Comfort::Choice& choice : Comfort::kChoices) {
    ASSERT_TRUE(v.key_to(std::string("comfort.") + choice.name)) << choice.name;
    EXPECT_TRUE(v.visit->shown_on().*choice.of) << choice.name;
  }
  ASSERT_TRUE(v.key_to("comfort.left_handed"));
  EXPECT_FALSE(v.visit->shown_on().left_handed);
  v.key(Key::back);
  EXPECT_TRUE(v.visit->control("choose.card.0"));
}

TEST(Comfort, ATouchBesideTheSwitchesChangesNothing) {
  Visitor v;
  v.touch("comfort");
  v.down(3, 3), v.up(3, 3);
  v.show();
  EXPECT_TRUE(v.visit->control("comfort.close"));
}

TEST(Comfort, TheWheelTurnsTheOtherWayAtOnceForALeftHandAtIt) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  ASSERT_GT(v.wheel_commands.wheels.back(), 0);
  const auto words = v.frame.items;
  v.touch("comfort");
  v.touch("comfort.left_handed");
  EXPECT_LT(v.wheel_commands.wheels.back(), 0);
  v.touch("comfort.left_handed");
  EXPECT_GT(v.wheel_commands.wheels.back(), 0);
}

TEST(Comfort, WithLessMotionThePictureChangesAtOnceAndThePotStandsToBeLookedAt) {
  Visitor v;
  v.touch("comfort");
  v.touch("comfort.reduced_motion");
  v.touch("comfort.close");
  EXPECT_EQ(v.frame.fade, 0);
  v.touch("choose.card.0");
  EXPECT_EQ(v.frame.fade, 0);
  v.touch("choose.throw");
  v.show();
  v.touch("throw.done");
  const double angle = v.frame.pot->clay_angle;
  v.frames(2);
  EXPECT_EQ(v.frame.pot->clay_angle, angle);
}

/// Of every screen: the size of its smallest words.
std::map<std::string, float> smallest(bool larger, std::pair<int, int> size) {
  std::map<std::string, float> found;
  Visitor v(9, nullptr, true);
  std::tie(v.width, v.height) = size;
  v.exhibit.screen.larger_text = larger;
  v.show();
  walk(v, [&](const std::string& name) {
    float least = 1000;
    for (const view::Item& item : v.frame.items)
      if (const auto* text = std::get_if<view::Text>(&item))
        least = std::min(least, text->style.px);
    found[name] = least;
  });
  return found;
}

TEST(Comfort, LargerTextIsLargerOnEveryScreen) {
  for (const auto& size : {std::pair{1920, 1080}, kPortrait}) {
    const auto usual = smallest(false, size), larger = smallest(true, size);
    for (const auto& [name, px] : usual)
      EXPECT_GE(larger.at(name), 1.14f * px) << name << " " << size.first << "x" << size.second;
  }
}

TEST(Comfort, LowReachIsReckonedFromHowLargeTheScreenIsAndHowHighItHangs) {
  settings::Exhibit::Screen screen;
  screen.diagonal_mm = 1000;  // 800 mm high and 600 wide: a pixel a millimetre.
  screen.lower_edge_mm = 700;
  EXPECT_EQ(in_reach(screen, 600, 800), (view::Rect{0, 0, 600, 800}));
  screen.low_reach = true;
  EXPECT_EQ(in_reach(screen, 600, 800), (view::Rect{0, 280, 600, 520}));
  screen.lower_edge_mm = 200;
  EXPECT_EQ(in_reach(screen, 600, 800), (view::Rect{0, 0, 600, 620}));
  screen.lower_edge_mm = 400;
  EXPECT_EQ(in_reach(screen, 600, 800), (view::Rect{0, 0, 600, 800}));
  // 5 m across, from 1 m up: 0.2 m of it are in reach, in which nothing has space.
  screen.diagonal_mm = 5000, screen.lower_edge_mm = 1000;
  EXPECT_EQ(in_reach(screen, 1920, 1080), (view::Rect{0, 720, 1920, 360}));
}

TEST(Comfort, InLowReachAPotIsWhereAHandReachesItAndWhereNoHandNeedsToItIsLargeAboveTheButtons) {
  double sizes[2] = {};
  for (const bool by_buttons : {false, true}) {
    Visitor v;
    std::tie(v.width, v.height) = kPortrait;
    v.exhibit.screen.lower_edge_mm = 1000;
    v.exhibit.screen.low_reach = true;
    v.exhibit.screen.one_switch = by_buttons;
    v.show();
    v.throw_a_pot();
    v.frames(1);
    const float line = in_reach(v.visit->shown_on(), v.width, v.height).y;
    ASSERT_GT(line, 0);
    const view::Camera& camera = v.frame.pot->camera;
    const float rim = camera.project({0, v.clay.rim_height(), 0})->second,
                foot = camera.project({0, 0, 0})->second;
    sizes[by_buttons ? 1 : 0] = foot - rim;
    EXPECT_TRUE(by_buttons || rim >= line) << rim;
    for (const auto& [id, rect] : v.visit->controls()) EXPECT_GE(rect.y, line - 0.5f) << id;
  }
  EXPECT_GT(sizes[1], 1.5 * sizes[0]);
}

TEST(Comfort, TheVolumeIsNoChoiceWhereTheExhibitHasNoSound) {
  Visitor v;
  v.touch("comfort");
  EXPECT_TRUE(v.visit->control("comfort.volume.0"));
  v.touch("comfort.close");
  v.exhibit.sound.volume = 0.0;
  v.show();
  v.touch("comfort");
  EXPECT_FALSE(v.visit->control("comfort.volume.0"));
}

TEST(Comfort, EachVisitorHasItAsLoudAsTheyLikeUpToWhatTheExhibitAllowsAndTheNextFindsItAsItWas) {
  Visitor v;
  v.down(600, 300), v.up(600, 300);
  v.show();
  EXPECT_EQ(v.visit->volume_share(), 1.0);
  v.touch("comfort");
  double before = -1;
  for (int step = 0; step <= Comfort::kLoudest; ++step) {
    v.touch(Comfort::volume_control(step));
    EXPECT_GT(v.visit->volume_share(), before);
    EXPECT_EQ(v.visit->shown_on().silent, step == 0);
    before = v.visit->volume_share();
  }
  EXPECT_EQ(before, 1.0);
  ASSERT_TRUE(v.key_to("comfort.volume.2"));
  EXPECT_EQ(v.visit->volume_share(), 0.5);
  v.touch("comfort.close");
  v.touch("back");
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  EXPECT_EQ(v.visit->volume_share(), 1.0);
  v.exhibit.screen.silent = true;
  EXPECT_EQ(v.visit->volume_share(), 0.0) << "as a curator has it";
}

TEST(Comfort, TheVolumeIsTheBarsThatAreFilledMirroredWhereOneReadsFromTheRight) {
  Visitor v;
  v.touch("comfort");
  v.touch("comfort.volume.3");
  int filled = 0;
  float last = -1;
  for (int step = 1; step <= Comfort::kLoudest; ++step) {
    const auto cell = *v.visit->control(Comfort::volume_control(step));
    EXPECT_GT(cell.x, last);
    last = cell.x;
    for (const view::Item& item : v.frame.items)
      if (const auto* box = std::get_if<view::Box>(&item);
          box && cell.contains(box->rect.x, box->rect.y) && box->rect.w < cell.w &&
          box->fill == view::kCobalt)
        ++filled;
  }
  EXPECT_EQ(filled, 3);
}

TEST(Comfort, LowReachIsNoChoiceWhereAllOfTheScreenIsInReach) {
  Visitor v;  // 294 mm high, from 900 mm
  v.touch("comfort");
  EXPECT_FALSE(v.visit->control("comfort.low_reach"));
  v.touch("comfort.close");
  v.exhibit.screen.lower_edge_mm = 1000;
  v.show();
  v.touch("comfort");
  EXPECT_TRUE(v.visit->control("comfort.low_reach"));
}

TEST(Comfort, WhereNoChoiceHasRoomForItsExplanationTheOneThatWasSwitchedLastIsExplained) {
  for (const bool room : {true, false}) {
    Visitor v = room ? portrait(1) : Visitor(1);
    const auto says = [&](const char* key) {
      return words_in(v.frame).find(v.languages.front().say(key)) != std::string::npos;
    };
    const auto choose = [&](const char* control) {
      v.touch(control);
      v.frames(1);
    };
    v.show();
    choose("comfort");
    EXPECT_TRUE(says("comfort.lead"));
    EXPECT_EQ(says("comfort.reduced_motion_is"), room);
    choose(room ? "comfort.reduced_motion" : "comfort.larger_text");
    EXPECT_EQ(says("comfort.lead"), room);
    EXPECT_TRUE(says("comfort.larger_text_is"));
    EXPECT_EQ(says("comfort.reduced_motion_is"), room);
    if (room) continue;
    choose("comfort.reduced_motion");
    EXPECT_TRUE(says("comfort.reduced_motion_is"));
    EXPECT_FALSE(says("comfort.larger_text_is"));
  }
}

}  // namespace
}  // namespace onggi::screens::comfort_test
