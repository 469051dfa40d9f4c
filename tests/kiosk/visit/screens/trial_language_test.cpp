#include "tests/kiosk/visit/screens/trial_language.h"

#include <gtest/gtest.h>

#include "kiosk/visit/screens/comfort.h"
#include "tests/kiosk/visit/screens/layout_check.h"

namespace onggi::screens::trial_language_test {
namespace {

void walk_in(const content::Language& language, std::pair<int, int> size, bool larger) {
  Visitor v(9, nullptr, true);
  std::tie(v.width, v.height) = size;
  v.languages = {language, v.languages.front()};
  v.exhibit.screen.larger_text = larger;
  v.put_tools_to_hand();
  v.keep_today(20);
  v.show();
  walk(v, [&](const std::string& name) { check_layout(v, v.plain, name); });
}

constexpr std::pair<int, int> kTrialSizes[] = {{1080, 1920}, {1920, 1080}, {1280, 720}};

TEST(TrialLanguage, LongWordsAreNowhereCutAndOverlapNothing) {
  const content::Language language = long_words();
  const std::string english =
      content::Language::read("content/languages/en.toml")->say("help.throw");
  EXPECT_GT(language.say("help.throw").size(), 1.35 * static_cast<double>(english.size()));
  for (const auto& size : kTrialSizes) walk_in(language, size, false);
}

TEST(TrialLanguage, WordsFromTheRightAreNowhereCutAndOverlapNothing) {
  const content::Language language = from_the_right();
  for (const auto& size : kTrialSizes) walk_in(language, size, false);
}

TEST(TrialLanguage, ThePotStaysWhereItIsWhicheverDrawerIsOpen) {
  for (const content::Language& language : {long_words(), from_the_right()})
    for (const auto& [width, height] : kTrialSizes) {
      Visitor v(3);
      v.width = width, v.height = height;
      v.languages = {language, v.languages.front()};
      v.put_tools_to_hand();
      v.throw_a_pot();
      v.frames(2);
      const view::Camera camera = v.frame.pot->camera;
      for (const char* drawer : {"throw.tools", "throw.wheel"}) {
        v.touch(drawer);
        EXPECT_EQ(v.frame.pot->camera, camera) << language.code() << ' ' << width << ' ' << drawer;
      }
      v.touch("throw.less");
      EXPECT_EQ(v.frame.pot->camera, camera) << language.code() << ' ' << width;
    }
}

TEST(TrialLanguage, WhatIsReadFromTheRightBeginsAtTheRight) {
  Visitor v(30);
  v.languages = {from_the_right(), v.languages.front()};
  v.show();
  v.touch("attract.begin");
  v.frames(1);
  const auto at = [&](const char* id) { return v.visit->control(id)->x; };
  EXPECT_GT(at("back"), at("help"));
  EXPECT_GT(at("help"), at("comfort"));
  EXPECT_GT(at("choose.card.0"), at("choose.card.1"));
  v.key(view::Key::left);
  v.key(view::Key::left);
  EXPECT_NE(v.visit->focus(), "choose.card.0") << "left is onward";
  v.touch("choose.card.0");
  v.touch("choose.throw");
  v.frames(2);
  // The column is on the right, and the pot on the left third.
  EXPECT_GT(at("throw.done"), 640);
  EXPECT_LT(v.frame.pot->camera.centre_x, 640);
  for (const view::Item& item : v.frame.items)
    if (const auto* text = std::get_if<view::Text>(&item)) {
      EXPECT_GT(text->box.x, 640) << text->text;
    }
}

}  // namespace
}  // namespace onggi::screens::trial_language_test
