#include "kiosk/visit/screens/language_page.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::language_page_test {
namespace {

using view::Key;
using view::Rect;

/// All that come with the exhibit, in an order of its own.
struct EightLanguages : Visitor {
  explicit EightLanguages(int w = 1280, int h = 720) {
    width = w;
    height = h;
    for (const char* code : {"es", "fr", "de", "ja", "zh", "ar"})
      languages.push_back(
          *content::Language::read(std::string("content/languages/") + code + ".toml"));
    show();
  }
  std::map<std::string, Rect> places() const {
    std::map<std::string, Rect> all;
    for (const content::Language& language : languages)
      if (const auto rect = visit->control(language_control(language)))
        all[language.code()] = *rect;
    return all;
  }
  void decorate() {
    offer("porcelain");
    make_result();
    frames(1);
    touch("result.keep");
    frames(1);
  }
};

TEST(LanguagePage, TheGlobeHasOnePlaceOnEveryScreen) {
  for (const auto& [w, h] : {std::pair{1920, 1080}, {1080, 1920}, {1366, 768}})
    for (const bool left : {false, true}) {
      Visitor v(9, nullptr, true);
      v.width = w;
      v.height = h;
      v.exhibit.screen.left_handed = left;
      v.keep_today(30);
      v.put_tools_to_hand();
      v.show();
      const auto first = v.visit->control("language");
      ASSERT_TRUE(first);
      int seen = 0;
      walk(v, [&](const std::string& name) {
        ++seen;
        const auto here = v.visit->control("language");
        ASSERT_TRUE(here) << name;
        EXPECT_NEAR(here->x, first->x, 0.01) << name << " " << v.width << "x" << v.height;
        EXPECT_NEAR(here->y, first->y, 0.01) << name << " " << v.width << "x" << v.height;
      });
      EXPECT_GT(seen, 20);
    }
}

TEST(LanguagePage, EachLanguageHasOnePlaceWhateverLanguageIsInUse) {
  for (const auto& [w, h] : {std::pair{1920, 1080}, {1080, 1920}, {1366, 768}}) {
    EightLanguages v(w, h);
    v.touch("language");
    const auto before = v.places();
    EXPECT_EQ(before.size(), 8u);
    for (const content::Language& language : v.languages) {
      v.touch(language_control(language));
      EXPECT_EQ(v.visit->language(), language.code());
      EXPECT_TRUE(v.places().empty()) << "a choice closes the page";
      v.touch("language");
      EXPECT_EQ(v.places(), before) << language.code() << " " << w << "x" << h;
      for (const Control& c : v.visit->reading().controls)
        if (c.on) {
          EXPECT_EQ(*c.on, c.id == language_control(language)) << c.id;
        }
      for (const content::Language& named : v.languages)
        EXPECT_NE(words_in(v.frame).find(named.name()), std::string::npos) << named.name();
    }
  }
}

TEST(LanguagePage, ATouchRightAfterAPageHasClosedPressesNothingThatLayBelow) {
  for (const auto& [way, closes] : {std::pair{"language", "language.ko"},
                                    {"language", "language.close"},
                                    {"help", "help.close"},
                                    {"comfort", "comfort.close"}}) {
    EightLanguages v;
    v.make_result();
    v.frames(1);
    const auto tap = [&](const Rect& at) {
      v.down(at.x + at.w / 2, at.y + at.h / 2);
      v.up(at.x + at.w / 2, at.y + at.h / 2);
    };
    const Rect keep = *v.visit->control("result.keep");
    v.touch(way);
    v.frames(0.5);
    tap(*v.visit->control(closes));
    v.now += 2;  // a slow machine: nobody has seen yet that the page is gone
    tap(keep);
    v.show();
    ASSERT_EQ(v.visit->reading().over, "") << closes;
    v.now += 2;  // nor while it is drawn for the first time
    tap(keep);
    v.show();
    const Rect there = *v.visit->control("result.keep");  // words differ by language
    for (int n = 0; n < 10; ++n) tap(there), v.show();
    EXPECT_EQ(v.visit->screen(), ScreenId::result) << closes;
    v.frames(std::string(way) == "language" ? 1.3 : 0.2);
    tap(there);
    v.show();
    EXPECT_EQ(v.visit->screen(), ScreenId::keepsake) << closes << ": later a touch is meant";
  }
}

// The next touch is often meant for what the page of languages had there.
TEST(LanguagePage, ASecondTouchWhereThePageHadAControlDoesNotSendThePotOn) {
  for (const auto& [w, h] : {std::pair{1280, 720}, {1080, 1920}})
    for (const char* chosen : {"language.en", "language.ko", "language.de", "language.ar"}) {
      EightLanguages v(w, h);
      v.decorate();
      ASSERT_EQ(v.visit->screen(), ScreenId::decorate);
      v.touch("language");
      v.frames(0.5);
      const auto had = v.visit->controls();
      const auto tap = [&](const Rect& at) {
        v.down(at.x + at.w / 2, at.y + at.h / 2);
        v.show();
        v.up(at.x + at.w / 2, at.y + at.h / 2);
        v.show();
      };
      tap(*v.visit->control(chosen));
      v.frames(0.6);
      for (const auto& [id, rect] : had) {
        tap(rect);
        if (id == "language") tap(*v.visit->control("language.close")), v.frames(0.6);
        ASSERT_EQ(v.visit->screen(), ScreenId::decorate) << chosen << " " << id << " " << w;
        if (v.visit->reading().over == "comfort") break;
      }
    }
}

TEST(LanguagePage, BackStandsWhereItStandsOnOtherScreensAndNotOnTheWayOn) {
  for (const auto& [w, h] : {std::pair{1280, 720}, {1080, 1920}, {1920, 1080}}) {
    EightLanguages v(w, h);
    v.decorate();
    const Rect back = *v.visit->control("back"), on = *v.visit->control("decorate.on");
    v.touch("language");
    const Rect close = *v.visit->control("language.close");
    EXPECT_NEAR(close.x, back.x, 20) << w;
    EXPECT_NEAR(close.y, back.y, 20) << w;
    for (const auto& [id, rect] : v.visit->controls())
      EXPECT_TRUE(rect.y + rect.h <= on.y || rect.y >= on.y + on.h || rect.x >= on.x + on.w ||
                  rect.x + rect.w <= on.x)
          << id << " " << w;
  }
}

TEST(LanguagePage, WhoClosesAPageByAKeyMayTouchAtOnce) {
  EightLanguages v;
  v.begin();
  v.key(Key::help);
  v.key(Key::back);
  v.touch("choose.card.0");
  EXPECT_TRUE(v.visit->control("choose.throw"));
}

TEST(LanguagePage, IsReachedAndLeftByKeysAndBeginsAtTheLanguageInUse) {
  EightLanguages v;
  v.throw_a_pot();
  v.key(Key::language);
  EXPECT_EQ(v.visit->reading().over, "languages");
  EXPECT_EQ(v.visit->focus(), "language.en");
  v.key(Key::back);
  EXPECT_EQ(v.visit->reading().over, "");
  v.key(Key::language);
  ASSERT_TRUE(v.key_to("language.de"));
  EXPECT_EQ(v.visit->language(), "de");
  EXPECT_EQ(v.visit->reading().over, "");
  v.key(Key::language);
  v.key(Key::language);
  EXPECT_EQ(v.visit->reading().over, "") << "the same key closes it";
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
}

TEST(LanguagePage, LeadsBackToThePageThatItCovered) {
  EightLanguages v;
  v.throw_a_pot();
  for (const std::string over : {"help", "comfort"}) {
    v.touch(over);
    v.speak("fr");
    EXPECT_EQ(v.visit->reading().over, over);
    v.touch(over + ".close");
  }
  v.frames(v.exhibit.idle.warn_after + 1);
  ASSERT_TRUE(v.visit->idle_warning());
  v.speak("ja");
  EXPECT_FALSE(v.visit->idle_warning());
  EXPECT_EQ(v.visit->reading().over, "");
}

TEST(LanguagePage, GoesAwayByItselfInAttract) {
  EightLanguages v;
  v.touch("language");
  EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  v.frames(70);
  EXPECT_EQ(v.visit->reading().over, "");
}

TEST(LanguagePage, AnExhibitOfOneLanguageHasNoGlobe) {
  Visitor v;
  v.languages.pop_back();
  v.show();
  EXPECT_FALSE(v.visit->control("language"));
}

}  // namespace
}  // namespace onggi::screens::language_page_test
