#include "kiosk/visit/screens/throwing_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "kiosk/picture/view/palette.h"
#include "kiosk/visit/screens/layout.h"
#include "kiosk/visit/screens/throwing_controls.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::throwing_screen_test {
namespace {

using view::Rect;

/// The tools of the exhibit's first scene lie to hand.
struct AtTheWheel : Visitor {
  AtTheWheel(int w, int h) {
    width = w;
    height = h;
    put_tools_to_hand();
    throw_a_pot();
    frames(2);
  }
  double mm(float px) const {
    return static_cast<double>(px) * exhibit.screen.diagonal_mm / std::hypot(width, height);
  }
  std::pair<float, float> seen(double x, double y) const {
    return *frame.pot->camera.project({x, y, 0});
  }
};

bool overlap(const Rect& a, const Rect& b) {
  return a.x + a.w > b.x && b.x + b.w > a.x && a.y + a.h > b.y && b.y + b.h > a.y;
}

/// The largest part of the screen about the pot in which nothing else stands.
Rect pots_own(const AtTheWheel& v) {
  const double radius = v.shelf[0].target.max_radius(), high = v.shelf[0].target.height();
  const Rect pot{v.seen(-radius, 0).first, v.seen(0, high).second,
                 v.seen(radius, 0).first - v.seen(-radius, 0).first,
                 v.seen(0, 0).second - v.seen(0, high).second};
  std::vector<Rect> others;
  for (const auto& [id, rect] : v.visit->controls()) others.push_back(rect);
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      const auto size = v.plain.measure(text->text, text->style, text->box.w);
      others.push_back({text->box.x, text->box.y, size.width, size.height});
    }
  std::set<float> lefts{0}, tops{0}, rights{static_cast<float>(v.width)},
      feet{static_cast<float>(v.height)};
  for (const Rect& o : others) {
    if (o.x + o.w <= pot.x) lefts.insert(o.x + o.w);
    if (o.y + o.h <= pot.y) tops.insert(o.y + o.h);
    if (o.x >= pot.x + pot.w) rights.insert(o.x);
    if (o.y >= pot.y + pot.h) feet.insert(o.y);
  }
  Rect best{0, 0, 0, 0};
  for (const float left : lefts)
    for (const float right : rights)
      for (const float top : tops)
        for (const float foot : feet) {
          const Rect room{left, top, right - left, foot - top};
          if (room.w * room.h > best.w * best.h &&
              std::none_of(others.begin(), others.end(),
                           [&](const Rect& o) { return overlap(o, room); }))
            best = room;
        }
  return best;
}

TEST(ThrowingScreen, ThePotOwnsIt) {
  const std::tuple<int, int, double> kLeast[] = {
      {1080, 1920, 0.68}, {1920, 1080, 0.66}, {1280, 720, 0.66}};
  for (const auto& [w, h, share] : kLeast)
    for (const bool korean : {false, true}) {
      AtTheWheel v(w, h);
      if (korean) v.speak("ko");
      const Rect room = pots_own(v);
      const float high = v.seen(0, 0).second - v.seen(0, v.shelf[0].target.height()).second;
      EXPECT_GE(static_cast<double>(room.w * room.h / static_cast<float>(w * h)), share)
          << w << "x" << h << ": the pot is " << v.mm(high) << " mm high on the screen";
    }
}

TEST(ThrowingScreen, WhatIsUsedMostIsAtLeastTwentyMillimetresHighAndNothingElseAsLarge) {
  for (const auto& [w, h] : {std::pair{1080, 1920}, {1920, 1080}, {1280, 720}}) {
    AtTheWheel v(w, h);
    v.status.can_restore = true;
    v.show();
    const std::set<std::string> most{"throw.water", "throw.show", "throw.done", "throw.restore"};
    std::set<std::string> seen;
    for (const auto& [id, rect] : v.visit->controls()) {
      if (most.count(id) == 0) {
        EXPECT_LT(v.mm(rect.h), 19.9) << id;
        continue;
      }
      seen.insert(id);
      EXPECT_GE(v.mm(rect.h), 19.9) << id;
      EXPECT_GE(v.mm(rect.w), 45) << id;
    }
    EXPECT_EQ(seen, most);
  }
}

TEST(ThrowingScreen, NothingMovesWhenThereIsAStrokeToTakeBackOrTheDrawerOpens) {
  for (const auto& [w, h] : {std::pair{1080, 1920}, {1280, 720}}) {
    AtTheWheel v(w, h);
    const auto before = v.visit->controls();
    const view::Camera camera = v.frame.pot->camera;
    v.status.can_restore = true;
    v.show();
    for (const auto& [id, rect] : before) EXPECT_EQ(v.visit->control(id), rect) << id;
    for (const char* drawer : {"throw.tools", "throw.wheel"}) {
      v.touch(drawer);
      EXPECT_EQ(v.frame.pot->camera, camera);
      for (const char* id : {"back", "help", "comfort", "language"})
        EXPECT_TRUE(v.visit->control(id)) << id;
    }
  }
}

TEST(ThrowingScreen, TheLinksAtTheFootStandInOneRowInEveryLanguageWhicheverDrawerIsOpen) {
  int apart = 0;
  for (const char* code : {"en", "ko", "es", "fr", "de", "ja", "zh", "ar"}) {
    AtTheWheel v(1080, 1920);
    v.languages.push_back(
        *content::Language::read(std::string("content/languages/") + code + ".toml"));
    v.visit->speak(code);
    v.frames(1);
    const auto foot = [&](const char* id) {
      const auto at = v.visit->control(id);
      return at ? at->y + at->h : -1;
    };
    const float links = foot("back");
    for (const char* id : {"help", "comfort", "language"})
      EXPECT_NEAR(foot(id), links, 1) << id << " " << code;
    EXPECT_NEAR(foot("throw.tools"), foot("throw.wheel"), 1) << code;
    apart += foot("throw.tools") < links - 1;
    const auto back = v.visit->control("help");
    v.touch("throw.wheel");
    if (foot("throw.less") < links - 1) {
      EXPECT_EQ(v.visit->control("help"), back) << code;
    }
  }
  EXPECT_GT(apart, 0) << "some languages need two rows";
  EXPECT_LT(apart, 8) << "and some need one";
}

/// How strongly the box under `control` is filled, 0..1.
float filled(const Visitor& v, const std::string& control) {
  const auto rect = v.visit->control(control);
  for (const view::Item& item : v.frame.items)
    if (const auto* box = std::get_if<view::Box>(&item); box && rect && box->rect == *rect)
      return box->fill.a;
  return -1;
}
bool solid(const Visitor& v, const std::string& control) { return filled(v, control) > 0.9f; }
/// A tick sits at the upper corner of `control`.
bool ticked(const Visitor& v, const std::string& control) {
  const auto rect = v.visit->control(control);
  return rect && std::ranges::any_of(v.frame.items, [&](const view::Item& item) {
           const auto* line = std::get_if<view::Line>(&item);
           return line != nullptr && line->points.size() == 3 &&
                  std::hypot(line->points[1].first - rect->x - rect->w,
                             line->points[1].second - rect->y) < 12;
         });
}

/// The clay on the wheel is what the line asks for.
void shape_it_right(Visitor& v) {
  v.shelf[0].target = v.clay.profile();
  v.frames(3);
}

TEST(ThrowingScreen, WhatIsOnIsTickedAndTintedAndOnlyTheStepOnwardIsSolid) {
  AtTheWheel v(1920, 1080);
  v.status.feedback.hand[0].contact = true;
  shape_it_right(v);
  EXPECT_FALSE(ticked(v, "throw.water"));
  EXPECT_EQ(filled(v, "throw.water"), 0);
  const auto rect = v.visit->control("throw.water");
  v.touch("throw.water");
  EXPECT_TRUE(ticked(v, "throw.water"));
  EXPECT_GT(filled(v, "throw.water"), 0);
  EXPECT_FALSE(solid(v, "throw.water"));
  EXPECT_EQ(v.visit->control("throw.water"), rect) << "the mark moves nothing";
  EXPECT_TRUE(solid(v, "throw.done"));
  EXPECT_FALSE(ticked(v, "throw.done"));
  v.touch("throw.inside");
  EXPECT_FALSE(v.visit->control("throw.inside")) << "the pot is seen again";
  v.touch("throw.tools");
  EXPECT_TRUE(ticked(v, "throw.inside"));
  EXPECT_FALSE(ticked(v, "throw.both"));
}

TEST(ThrowingScreen, UndoStandsAtItsPlaceFromTheStartAndCanBePressedOnceThereIsAStroke) {
  for (const bool spoken : {false, true}) {
    AtTheWheel v(1920, 1080);
    if (spoken) {
      v.exhibit.screen.spoken = true;
      v.frames(1);
    }
    const auto place = [&] {
      for (const view::Item& item : v.frame.items)
        if (const auto* text = std::get_if<view::Text>(&item); text && text->text == "Undo")
          return text->box;
      return Rect{};
    };
    const Rect before = place();
    EXPECT_GT(before.w, 0) << "it is seen";
    EXPECT_FALSE(v.visit->control("throw.restore")) << "and cannot be pressed";
    v.status.can_restore = true;
    v.show();
    EXPECT_EQ(place(), before);
    EXPECT_TRUE(v.visit->control("throw.restore"));
  }
}

TEST(ThrowingScreen, OneButtonIsSolidWhatAVisitorWantsMostNow) {
  AtTheWheel v(1920, 1080);
  v.touch_clay();
  shape_it_right(v);
  EXPECT_TRUE(solid(v, "throw.done"));
  for (const char* drawer : {"throw.tools", "throw.wheel"}) {
    v.touch(drawer);
    EXPECT_TRUE(solid(v, "throw.less")) << drawer;
    EXPECT_FALSE(solid(v, "throw.done")) << drawer;
    v.touch("throw.less");
  }
  content::LessonStep step;
  step.until = content::DoneWhen::rim;
  step.after = 1000;
  step.words["en"] = "Steady the rim";
  v.lesson.push_back(step);
  step.until = content::DoneWhen::cut;
  v.lesson.push_back(step);
  v.show();
  ASSERT_TRUE(v.visit->control("throw.skip"));
  EXPECT_FALSE(solid(v, "throw.done")) << "the lesson goes on";
  v.touch("throw.skip");
  EXPECT_TRUE(solid(v, "throw.done"));
}

TEST(ThrowingScreen, DoneIsTheStepOnwardOnceTheClayWasTouchedAndNotBefore) {
  AtTheWheel v(1920, 1080);
  EXPECT_FALSE(solid(v, "throw.done"));
  v.key(view::Key::enter);
  EXPECT_EQ(v.visit->reading().first, "throw.show") << "Enter twice keeps no untouched lump";
  v.status.feedback.hand[0].contact = true;
  shape_it_right(v);
  EXPECT_TRUE(solid(v, "throw.done"));
  EXPECT_EQ(v.visit->reading().first, "throw.done");
}

TEST(ThrowingScreen, DoneIsNotSolidWhileTheWordsAskForSomethingElse) {
  AtTheWheel v(1920, 1080);
  v.touch_clay();
  v.frames(3);
  EXPECT_FALSE(solid(v, "throw.done")) << "a lump is far from the vessel";
  shape_it_right(v);
  EXPECT_TRUE(solid(v, "throw.done"));
  // One ring is out by more than the line allows, and the pot is good all the same.
  for (ProfilePoint& p : v.shelf[0].target.points)
    if (std::abs(p.height - 0.1) < 0.012) p.outer *= 1.05;
  v.frames(3);
  EXPECT_EQ(words_in(v.frame).find("Right on the line"), std::string::npos);
  EXPECT_TRUE(solid(v, "throw.done")) << v.visit->sight()->hint.key;
  v.status.feedback.wetness = 0;
  v.status.feedback.hand[0].contact = true;
  for (int n = 0; n < 120 && v.visit->sight()->hint.key != "hint.dry"; ++n) v.frames(0.5);
  ASSERT_EQ(v.visit->sight()->hint.key, "hint.dry");
  EXPECT_FALSE(solid(v, "throw.done")) << "water is asked for";
}

TEST(ThrowingScreen, WaterIsAskedForOnceThenItsButtonBlinksAndTheShapesHintComesBack) {
  AtTheWheel v(1920, 1080);
  const auto says = [&](const char* key) {
    return words_in(v.frame).find(v.languages[0].say(key)) != std::string::npos;
  };
  v.status.feedback.hand[0].contact = true;
  v.frames(19);
  EXPECT_FALSE(says("hint.dry"));
  v.frames(4);
  EXPECT_TRUE(says("hint.dry"));
  v.frames(8);
  EXPECT_FALSE(says("hint.dry"));
  std::set<float> looks;
  for (int n = 0; n < 60; ++n) v.show(), looks.insert(filled(v, "throw.water"));
  EXPECT_EQ(looks.size(), 2u) << "it blinks";
  EXPECT_FALSE(ticked(v, "throw.water")) << "it is not on";
  v.status.feedback.wetness = 0.5;
  v.frames(0.1);
  looks.clear();
  for (int n = 0; n < 60; ++n) v.show(), looks.insert(filled(v, "throw.water"));
  EXPECT_EQ(looks, std::set<float>{0});
}

TEST(ThrowingScreen, TwoDrawersHoldAllElseAndAHandOnThePotClosesThem) {
  const std::vector<std::string> of_tools{"throw.tool.0", "throw.tool.8", "throw.both",
                                          "throw.outside", "throw.inside"},
      of_wheel{"throw.slower", "throw.faster", "throw.cut", "throw.renew"};
  for (const auto& [drawer, mine, others] :
       {std::tuple("throw.tools", of_tools, of_wheel), {"throw.wheel", of_wheel, of_tools}}) {
    AtTheWheel v(1080, 1920);
    const auto done = v.visit->control("throw.done");
    v.touch(drawer);
    for (const std::string& id : mine) {
      EXPECT_TRUE(v.visit->control(id)) << id;
      EXPECT_EQ(way_into_drawer(id), drawer);
    }
    for (const std::string& id : others) EXPECT_FALSE(v.visit->control(id)) << id;
    EXPECT_EQ(v.visit->control("throw.done"), done) << "what is used most stays";
    EXPECT_EQ(way_into_drawer("throw.done"), "");
    v.touch("back");
    EXPECT_FALSE(v.visit->control(mine.front())) << "Back closes it";
    EXPECT_EQ(v.visit->screen(), ScreenId::throwing) << "and the visitor stays";
    v.touch(drawer);
    const auto inside = v.seen(0.05, 0.1);
    const float x = inside.first;
    float y = inside.second;
    // The tools lie over the pot, and a touch on one takes it up.
    const auto on_a_control = [&](const auto& one) { return one.second.contains(x, y); };
    while (std::ranges::any_of(v.visit->controls(), on_a_control)) y -= 10;
    ASSERT_GT(y, 0) << "there is room beside them";
    v.down(x, y);
    v.show();
    EXPECT_FALSE(v.visit->control(mine.front()));
    // Through the tools nobody sees the pot well enough to touch it.
    const bool worked = !v.wheel_commands.hands.empty() && v.wheel_commands.hands.back().active;
    EXPECT_EQ(worked, drawer != std::string("throw.tools"));
  }
}

TEST(ThrowingScreen, WhatIsUsedMostStaysWhicheverDrawerIsOpen) {
  for (const auto& [w, h] : {std::pair{1080, 1920}, {1280, 720}, {1024, 600}})
    for (const bool by_buttons : {false, true}) {
      AtTheWheel v(w, h);
      v.exhibit.screen.one_switch = by_buttons;
      v.frames(2);
      for (const char* drawer : {"throw.tools", "throw.wheel"})
        for (const char* most : {"throw.done", "throw.water"}) {
          const auto closed = v.visit->control(most);
          ASSERT_TRUE(closed) << w << most;
          v.touch(drawer);
          EXPECT_EQ(v.visit->control(most), closed) << w << drawer << most << by_buttons;
          v.touch("throw.less");
        }
    }
}

TEST(ThrowingScreen, AToolInTheHandIsNamedWhereAnotherIsTakenUp) {
  AtTheWheel v(1280, 720);
  EXPECT_NE(words_in(v.frame).find("Tools\n"), std::string::npos);
  v.touch("throw.tool.4");
  EXPECT_NE(words_in(v.frame).find("Flat rib\n"), std::string::npos);
  EXPECT_EQ(words_in(v.frame).find("Tools\n"), std::string::npos);
}

/// The dimmed pot lies behind the words, black clay in the plaster's darkest corner at worst
/// (layout_check.cpp).
TEST(ThrowingScreen, WhatAToolDoesIsReadOverAnyPot) {
  AtTheWheel v(1280, 720);
  v.touch("throw.tools");
  v.frames(1);
  const auto left = static_cast<float>(1 - v.frame.pot->opacity);
  const view::Color ground{0.8811f * left, 0.8597f * left, 0.8294f * left, 1};
  int read = 0;
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item); text && text->color == view::kFaintInk) {
      EXPECT_GE(view::contrast(text->color, ground), 4.5) << text->text;
      ++read;
    }
  EXPECT_GE(read, 8);
}

TEST(ThrowingScreen, NoWordOfAToolsNameIsBroken) {
  for (const auto& [w, h] : {std::pair{1080, 1920}, {1280, 720}, {1024, 600}}) {
    AtTheWheel v(w, h);
    v.touch("throw.tools");
    v.frames(1);
    for (const view::Item& item : v.frame.items)
      if (const auto* text = std::get_if<view::Text>(&item); text && text->text == "Sponge") {
        EXPECT_LE(v.plain.measure("Sponge", text->style, -1).width, text->box.w) << w;
      }
  }
}

}  // namespace
}  // namespace onggi::screens::throwing_screen_test
