#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "kiosk/picture/render/text.h"
#include "kiosk/visit/screens/moved_light.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::kiln_test {
namespace {

using view::Finish;
using view::Key;

/// Someone whose pot goes through the kiln.
struct KilnVisitor : Visitor {
  KilnVisitor() : Visitor(9, nullptr, true) {}
  const view::PotView& pot() const { return *frame.pot; }
  std::vector<MakeKeepsake> kept() {
    std::vector<MakeKeepsake> all;
    for (const Request& r : requests())
      if (const auto* one = std::get_if<MakeKeepsake>(&r)) all.push_back(*one);
    return all;
  }
};

TEST(KilnScreen, APotDriesWhileItsGlazeIsBeingChosenAndIsNotFiredWithoutOne) {
  KilnVisitor v;
  v.make_result();
  v.touch("result.keep");
  ASSERT_EQ(v.visit->screen(), ScreenId::kiln);
  EXPECT_FALSE(v.visit->control("kiln.keep"));
  EXPECT_GT(v.pot().size, 0.99);
  v.frames(8);
  EXPECT_NEAR(v.pot().size, 0.9375, 1e-9);
  EXPECT_EQ(v.pot().finish, Finish::clay);
  EXPECT_FALSE(v.pot().wheel) << "it was cut off and stands by itself";
}

TEST(KilnScreen, NothingBesideThePotMovesFromTheChoiceOfAGlazeToTheEndOfTheFiring) {
  const render::Typesetter fonts;
  for (const std::filesystem::path file :
       {"content/languages/de.toml", "content/languages/ja.toml"})
    for (const auto& [width, height] : {std::pair{1280, 720}, {1080, 1920}})
      for (const bool decorated : {false, true}) {
        Visitor v(2, &fonts, true);
        v.languages = {*content::Language::read(file)};
        v.width = width, v.height = height;
        if (decorated) v.offer("celadon");
        v.make_result();
        v.frames(0.5);
        v.touch("result.keep");
        if (decorated) {
          v.touch("decorate.mark");
          v.touch("decorate.on");
        }
        v.frames(0.5);
        const view::Rect glaze = *v.visit->control("kiln.glaze.1");
        v.touch("kiln.glaze.1");
        v.frames(0.2);
        ASSERT_TRUE(v.visit->control("kiln.glaze.1") == glaze) << file << width << decorated;
        const auto before = v.visit->controls();
        const auto title = [&] {
          for (const view::Item& item : v.frame.items)
            if (const auto* text = std::get_if<view::Text>(&item);
                text != nullptr && text->style.face == view::Face::serif)
              return text->box;
          return view::Rect{};
        };
        const view::Rect title_before = title();
        for (int n = 0; n < 24; ++n) {
          v.frames(0.5);
          const std::string where =
              file.string() + " " + std::to_string(width) + (decorated ? " decorated" : "");
          for (const auto& [id, rect] : before)
            ASSERT_TRUE(v.visit->control(id) == rect) << where << " " << id << " " << n;
          ASSERT_EQ(title().y, title_before.y) << where << " " << n;
        }
      }
}

TEST(KilnScreen, ThereAreAtLeastThreeGlazesAndEachOneFiresThePot) {
  ASSERT_GE(KilnVisitor().glazes.size(), 3u);
  for (std::size_t i = 0; i < KilnVisitor().glazes.size(); ++i) {
    KilnVisitor v;
    v.make_result();
    v.touch("result.keep");
    v.touch("kiln.glaze." + std::to_string(i));
    v.frames(10);
    EXPECT_EQ(v.pot().finish, Finish::fired);
    EXPECT_EQ(v.pot().glazing.look.glass, v.glazes[i].look.glass);
    v.touch("kiln.keep");
    const auto kept = v.kept();
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept[0].glaze, static_cast<int>(i));
  }
}

TEST(KilnScreen, APotThatTheVisitorGlazedIsNotOfferedNoGlaze) {
  for (const bool glazed : {false, true}) {
    Visitor v(2, nullptr, true);
    v.offer("onggi");
    v.make_result();
    v.touch("result.keep");
    const auto& tools = v.way->tools;
    for (std::size_t n = 0; glazed && n < tools.size(); ++n)
      if (tools[n].id == "glaze") v.touch("decorate.tool." + std::to_string(n));
    if (glazed) v.touch("decorate.mark");
    v.frames(4);
    v.touch("decorate.on");
    v.frames(0.5);
    int none = 0;
    for (std::size_t n = 0; n < v.glazes.size(); ++n)
      none += v.glazes[n].look.gloss < 0.3f &&
              v.visit->control("kiln.glaze." + std::to_string(n)).has_value();
    EXPECT_EQ(none, glazed ? 0 : 1);
    EXPECT_TRUE(v.visit->control(v.visit->focus()) || v.visit->focus().empty());
    EXPECT_EQ(words_in(v.frame).find("Choose the colour of your glaze.") != std::string::npos,
              glazed);
  }
}

TEST(KilnScreen, WhereNoGlazeMeltsAPotThatTheVisitorGlazedHasAllOfThem) {
  Visitor v(2, nullptr, true);
  for (content::Glaze& glaze : v.glazes) glaze.look.gloss = 0;
  v.offer("onggi");
  v.make_result();
  v.touch("result.keep");
  for (std::size_t n = 0; n < v.way->tools.size(); ++n)
    if (v.way->tools[n].id == "glaze") v.touch("decorate.tool." + std::to_string(n));
  v.touch("decorate.mark");
  v.frames(4);
  v.touch("decorate.on");
  v.frames(0.5);
  EXPECT_TRUE(v.visit->control("kiln.glaze.0"));
  v.touch("kiln.glaze.0");
  EXPECT_TRUE(v.visit->control("kiln.keep"));
}

TEST(KilnScreen, ThePotGlowsAndShrinksAndTheGlazeComesWithoutAJump) {
  KilnVisitor v;
  v.make_result();
  v.touch("result.keep");
  v.touch("kiln.glaze.0");
  double size = v.pot().size, done = 0, hottest = 0;
  for (int i = 0; i < 260; ++i) {
    v.show();
    EXPECT_LE(v.pot().size, size + 1e-12);
    EXPECT_LT(size - v.pot().size, 0.01);
    size = v.pot().size;
    if (v.pot().finish != Finish::firing) continue;
    EXPECT_GE(v.pot().firing.done, done);
    EXPECT_LT(v.pot().firing.done - done, 0.05);
    done = v.pot().firing.done;
    hottest = std::max(hottest, v.pot().firing.glow);
  }
  EXPECT_GT(hottest, 0.95);
  EXPECT_GT(done, 0.95);
  EXPECT_NEAR(size, 0.875, 1e-9);
  EXPECT_EQ(v.pot().finish, Finish::fired);
}

TEST(KilnScreen, AFingerDrawsTheLightRoundTheFiredPotAndATouchAloneDoesNot) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  const auto says_so = [&] {
    return std::ranges::any_of(v.frame.items, [](const view::Item& item) {
      const auto* text = std::get_if<view::Text>(&item);
      return text != nullptr && text->text == "Draw the light from side to side.";
    });
  };
  EXPECT_EQ(v.pot().window, view::kWindowLeft);
  EXPECT_TRUE(says_so());
  v.down(900, 300), v.up(900, 300), v.show();
  EXPECT_EQ(v.pot().window, view::kWindowLeft);
  v.down(700, 300), v.show();
  double before = v.pot().window;
  for (float x = 740; x < 1000; x += 40) {
    v.move(x, 320), v.show();
    EXPECT_GT(v.pot().window, before) << "it goes with the finger";
    before = v.pot().window;
  }
  EXPECT_FALSE(says_so());
  EXPECT_EQ(v.pot().finish, Finish::fired);
  v.move(-4000, 320), v.up(-4000, 320), v.show();
  EXPECT_EQ(v.pot().window, -MovedLight::kFarthest);
  v.move(900, 320), v.show();
  EXPECT_EQ(v.pot().window, -MovedLight::kFarthest) << "no finger is down";
}

TEST(KilnScreen, NoLightThrowsAShadowOnAButton) {
  for (const bool left_handed : {false, true})
    for (const auto& [width, height] :
         {std::pair{1280, 720}, {1920, 1080}, {1024, 600}, {1080, 1920}}) {
      KilnVisitor v;
      v.exhibit.screen.left_handed = left_handed;
      v.width = width, v.height = height;
      v.make_result();
      v.glaze_and_fire();
      const bool mirrored = left_handed && width > height;
      const double own = mirrored ? view::kWindowRight : view::kWindowLeft;
      for (const float to : {-9000.0f, 9000.0f}) {
        const float x = 0.5f * static_cast<float>(v.width);
        v.down(x, 30), v.move(to, 30), v.up(to, 30), v.show();
        EXPECT_NE(v.pot().window, own);
        check_layout(v, v.plain, to < 0 ? "light at the left" : "light at the right");
      }
    }
}

TEST(KilnScreen, ALightThatWasMovedLeavesTheWordsFreeForTheOtherHandToo) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  v.down(900, 300), v.move(-9000, 300), v.up(-9000, 300), v.show();
  ASSERT_EQ(v.pot().window, -MovedLight::kFarthest);
  v.exhibit.screen.left_handed = true;
  v.frames(0.2);
  EXPECT_EQ(v.pot().window, -MovedLight::kNearWords);
}

TEST(KilnScreen, AFingerThatSkipsTheFiringDrawsTheLightOn) {
  KilnVisitor v;
  v.make_result();
  v.touch("result.keep");
  v.touch("kiln.glaze.0");
  v.down(800, 300), v.show();
  EXPECT_EQ(v.pot().finish, Finish::fired);
  v.move(900, 300), v.show();
  EXPECT_GT(v.pot().window, view::kWindowLeft);
}

TEST(KilnScreen, ArrowsAndOneButtonMoveTheLightToo) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  for (int n = 0; n < 20 && v.visit->focus() != "kiln.light"; ++n) v.key(Key::next);
  ASSERT_EQ(v.visit->focus(), "kiln.light");
  v.key(Key::right), v.show();
  EXPECT_NEAR(v.pot().window, view::kWindowLeft + MovedLight::kAnArrow, 1e-9);
  v.key(Key::left), v.show();
  EXPECT_NEAR(v.pot().window, view::kWindowLeft, 1e-9);
  double least = 9, most = -9;
  for (int n = 0; n < 6; ++n) {
    v.key(Key::enter), v.show();
    least = std::min(least, v.pot().window), most = std::max(most, v.pot().window);
  }
  EXPECT_EQ(least, -MovedLight::kFarthest) << "and round again";
  EXPECT_EQ(most, MovedLight::kNearWords);
}

TEST(KilnScreen, TheWordsSayHowMuchItShrankInBothLanguages) {
  KilnVisitor v;
  v.make_result();
  EXPECT_EQ(words_in(v.frame).find("175 mm"), std::string::npos);
  v.glaze_and_fire();
  EXPECT_NE(words_in(v.frame).find(
                "It shrank by 12.5 % in drying and firing: 200 mm (thin line) → 175 mm."),
            std::string::npos)
      << words_in(v.frame);
  v.speak("ko");
  EXPECT_NE(words_in(v.frame).find("12.5 % 줄었습니다. 200 mm(가는 선) → 175 mm"),
            std::string::npos);
  EXPECT_NE(words_in(v.frame).find("백자"), std::string::npos);
}

// A line that no word explains is a riddle.
TEST(KilnScreen, TheThrownSizeIsALineOnlyWhereTheWordsSaySo) {
  KilnVisitor v;
  const auto lines = [&] {
    return std::ranges::count_if(v.frame.items, [](const view::Item& item) {
      return std::holds_alternative<view::Line>(item);
    });
  };
  v.make_result();
  v.touch("result.keep");
  const auto without = lines();
  v.frames(6);
  EXPECT_EQ(lines(), without) << "it dries, and no glaze is chosen";
  v.touch("kiln.glaze.0");
  v.frames(2);
  EXPECT_GT(lines(), without);
  EXPECT_NE(words_in(v.frame).find("thin line"), std::string::npos) << words_in(v.frame);
  v.frames(10);
  EXPECT_GT(lines(), without);
  EXPECT_NE(words_in(v.frame).find("thin line"), std::string::npos) << words_in(v.frame);
}

TEST(KilnScreen, TheWordsAreThoseOfAPersonWhoTalks) {
  KilnVisitor v;
  v.offer("porcelain");
  v.make_result();
  v.touch("result.keep");
  v.touch("decorate.mark");
  v.frames(5);
  v.touch("decorate.tool.1");
  v.touch("decorate.mark");
  v.frames(5);
  v.touch("decorate.on");
  const std::string said = words_in(v.frame);
  EXPECT_NE(said.find("Your pot is drying"), std::string::npos) << said;
  EXPECT_NE(said.find("You decorated it yourself: bands painted, then figures painted."),
            std::string::npos)
      << said;
  EXPECT_EQ(said.find("Hides"), std::string::npos) << said;
  EXPECT_NE(said.find("Your drawing will hardly show under Tenmoku."), std::string::npos) << said;
}

TEST(KilnScreen, WhereALanguageWritesACommaItShrankByThat) {
  KilnVisitor v;
  v.languages = {*content::Language::read("content/languages/de.toml")};
  v.make_result();
  v.glaze_and_fire();
  EXPECT_NE(words_in(v.frame).find(" 12,5"), std::string::npos) << words_in(v.frame);
}

TEST(KilnScreen, AnotherGlazeDissolvesOverTheFirstAndTheLastChoiceIsKept) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  v.touch("kiln.glaze.3");
  v.frames(0.5);
  ASSERT_EQ(v.pot().finish, Finish::firing);
  ASSERT_TRUE(v.pot().firing.from);
  EXPECT_EQ(v.pot().firing.from->look.glass, v.glazes[1].look.glass);
  EXPECT_NEAR(v.pot().size, 0.875, 1e-9) << "it shrinks once";
  // A change of mind in the middle is carried out when this one is done.
  v.touch("kiln.glaze.2");
  EXPECT_EQ(v.pot().glazing.look.glass, v.glazes[3].look.glass);
  v.frames(6);
  EXPECT_EQ(v.pot().glazing.look.glass, v.glazes[2].look.glass);
  v.touch("kiln.keep");
  const auto kept = v.kept();
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].glaze, 2);
}

TEST(KilnScreen, NothingHasToBeWaitedFor) {
  KilnVisitor touching;
  touching.make_result();
  touching.touch("result.keep");
  touching.touch("kiln.glaze.0");
  touching.down(900, 300);
  touching.up(900, 300);
  touching.show();
  EXPECT_EQ(touching.pot().finish, Finish::fired);

  KilnVisitor hurried;
  hurried.make_result();
  hurried.touch("result.keep");
  hurried.touch("kiln.glaze.4");
  hurried.touch("kiln.keep");
  EXPECT_EQ(hurried.visit->screen(), ScreenId::keepsake);
  EXPECT_EQ(hurried.kept().at(0).glaze, 4);

  KilnVisitor still;
  still.exhibit.screen.reduced_motion = true;
  still.make_result();
  still.touch("result.keep");
  EXPECT_NEAR(still.pot().size, 0.9375, 1e-9);
  still.touch("kiln.glaze.0");
  EXPECT_EQ(still.pot().finish, Finish::fired);
}

TEST(KilnScreen, GoingBackFindsTheGlazeAndAnotherOneIsKeptAsWell) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  v.touch("kiln.keep");
  v.touch("back");
  ASSERT_EQ(v.visit->screen(), ScreenId::kiln);
  EXPECT_EQ(v.pot().finish, Finish::fired);
  v.touch("kiln.keep");
  EXPECT_EQ(v.kept().size(), 1u) << "the same pot is kept once";
  v.touch("back");
  v.touch("kiln.glaze.0");
  v.touch("kiln.keep");
  EXPECT_EQ(v.kept().size(), 1u);
  // Thrown on, it is raw clay again.
  v.touch("back");
  v.touch("back");
  v.touch("back");
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  v.touch("throw.done");
  v.touch("result.keep");
  EXPECT_EQ(v.pot().finish, Finish::clay);
}

TEST(KilnScreen, ItGoesByKeyboardAlone) {
  KilnVisitor v;
  v.make_result();
  ASSERT_TRUE(v.key_to("result.keep"));
  ASSERT_TRUE(v.key_to("kiln.glaze.2"));
  v.frames(10);
  EXPECT_EQ(v.pot().finish, Finish::fired);
  ASSERT_TRUE(v.key_to("kiln.keep"));
  EXPECT_EQ(v.kept().at(0).glaze, 2);
  v.key(Key::back);
  EXPECT_EQ(v.visit->screen(), ScreenId::kiln);
  v.key(Key::back);
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
}

TEST(KilnScreen, TheNextVisitorFindsNoGlaze) {
  KilnVisitor v;
  v.make_result();
  v.glaze_and_fire();
  v.touch("kiln.keep");
  v.visit->keepsake_kept("quiet blue heron");
  v.touch("keepsake.done");
  v.touch("keepsake.done");
  v.make_result();
  v.touch("result.keep");
  EXPECT_FALSE(v.visit->control("kiln.keep"));
}

TEST(KilnScreen, WithoutAKilnAPotIsKeptUnfired) {
  Visitor v;
  v.make_result();
  v.touch("result.keep");
  EXPECT_EQ(v.visit->screen(), ScreenId::keepsake);
  for (const Request& r : v.requests())
    if (const auto* one = std::get_if<MakeKeepsake>(&r)) {
      EXPECT_EQ(one->glaze, -1);
    }
  v.visit->show_postcard(3);
  v.show();
  EXPECT_EQ(words_in(v.frame).find("Fired"), std::string::npos);
}

}  // namespace
}  // namespace onggi::screens::kiln_test
