#include "kiosk/visit/screens/stroke_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "kiosk/picture/render/text.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/kiosk/visit/screens/trial_language.h"
#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::stroke_board_test {
namespace {

using device::Ask;
using device::WallPart;

/// With a board at the wheel.
Visitor at_the_wheel(bool kiln = false) {
  Visitor v(9, nullptr, kiln);
  v.exhibit.screen.spoken = true;
  v.show();
  v.throw_a_pot();
  v.frames(1);
  return v;
}

const Control* find(const ScreenText& reading, const std::string& id) {
  for (const Control& c : reading.controls)
    if (c.id == id) return &c;
  return nullptr;
}

Profile tube(double radius) {
  Profile p;
  for (int n = 0; n <= 100; ++n) p.points.push_back({0.002 * n, radius, radius - 0.005});
  return p;
}

TEST(StrokeBoard, EachPartIsOffByTheMeanOfWhatItIsOff) {
  ShelfCard card;
  card.target = tube(0.05);
  Profile made = tube(0.05);
  for (auto& point : made.points)
    point.outer += 0.004 * device::weight_of(WallPart::high, point.height / 0.2);
  const auto parts = parts_off(&card, made);
  ASSERT_EQ(parts.size(), 5u);
  for (const PartOff& part : parts) {
    EXPECT_EQ(part.near, part.part != WallPart::high) << static_cast<int>(part.part);
    EXPECT_GE(part.off, -1e-9);
  }
  EXPECT_GT(parts[3].off, 0.004) << "of the diameter";
  EXPECT_LT(parts[3].off, 0.008);
  for (const PartOff& part : parts_off(&card, {})) EXPECT_TRUE(part.near);
  EXPECT_TRUE(parts_off(nullptr, made).empty());
}

TEST(StrokeBoard, IsThereForWhomItIsReadAndForOneSwitchAndForNobodyElse) {
  for (const int who : {0, 1, 2}) {
    Visitor v;
    v.exhibit.screen.spoken = who == 1;
    v.exhibit.screen.one_switch = who == 2;
    v.show();
    v.throw_a_pot();
    EXPECT_EQ(v.visit->control("throw.ask.1").has_value(), who > 0);
  }
}

TEST(StrokeBoard, AStrokeIsMadeByTheVisitorsHandsWhereItWasAskedAndToldUntilItIsOver) {
  Visitor v = at_the_wheel();
  v.touch("throw.part.3");
  v.touch("throw.ask.2");
  v.frames(1.5);
  ScreenText reading = v.visit->reading();
  EXPECT_TRUE(reading.working);
  EXPECT_NE(words_in(v.frame).find("The hands are working: Narrow, High."), std::string::npos);
  ASSERT_GE(v.wheel_commands.hands.size(), 2u);
  const HandInput& hand = v.wheel_commands.hands[v.wheel_commands.hands.size() - 2];
  EXPECT_TRUE(hand.active);
  EXPECT_GT(hand.position.y, 0.5 * 0.2) << "high on the wall";
  v.frames(20);
  reading = v.visit->reading();
  EXPECT_FALSE(reading.working);
  EXPECT_EQ(words_in(v.frame).find("at work"), std::string::npos);
}

TEST(StrokeBoard, BesideTheSwitchsRingStandsNoOther) {
  for (const bool one_switch : {false, true}) {
    Visitor v = at_the_wheel();
    v.exhibit.screen.one_switch = one_switch;
    v.visit->activate("throw.part.1", v.now);
    v.show();
    EXPECT_EQ(v.visit->focus().empty(), one_switch);
  }
}

TEST(StrokeBoard, AskedWhereThePotDiffersItSaysItOnTheScreenInMillimetresOfTheVessel) {
  Visitor v = at_the_wheel();
  EXPECT_EQ(v.visit->reading().asked, 0);
  v.key(view::Key::tell);
  const ScreenText reading = v.visit->reading();
  EXPECT_EQ(reading.asked, 1);
  ASSERT_FALSE(reading.differences.empty());
  EXPECT_LE(reading.differences.size(), 2u);
  EXPECT_NE(reading.differences.front().find(" mm too "), std::string::npos);
  EXPECT_NE(words_in(v.frame).find(reading.differences.front()), std::string::npos);
  v.touch("throw.ask.4");
  EXPECT_EQ(words_in(v.frame).find(reading.differences.front()), std::string::npos);
}

TEST(StrokeBoard, UnaskedItNamesThePartThatDiffersMostAndNeverHowToDraw) {
  Visitor v = at_the_wheel();
  v.frames(3);
  const std::string words = words_in(v.frame), worst = v.visit->reading().differences.front();
  EXPECT_NE(words.find(worst), std::string::npos);
  for (const char* drawn : {"Touch the clay", "drag", "Press", "to the line"})
    EXPECT_EQ(words.find(drawn), std::string::npos) << drawn;
}

TEST(StrokeBoard, APartSaysHowMuchItIsOffAndWhetherItIsTheOneThatIsWorked) {
  Visitor v = at_the_wheel();
  v.touch("throw.part.1");
  const ScreenText reading = v.visit->reading();
  for (int n = 0; n < device::kWallParts; ++n) {
    const Control* part = find(reading, "throw.part." + std::to_string(n));
    ASSERT_NE(part, nullptr);
    EXPECT_EQ(part->on, std::optional(n == 1));
    EXPECT_EQ(part->note.empty(), n == static_cast<int>(WallPart::all));
  }
}

TEST(StrokeBoard, ArrowsTabAndEnterComeToEveryControlAndMoveNoHand) {
  Visitor v = at_the_wheel();
  v.key(view::Key::next);
  const std::size_t before = v.wheel_commands.hands.size();
  std::set<std::string> seen;
  const std::size_t all = v.visit->controls().size();
  for (std::size_t n = 0; n < all; ++n) {
    seen.insert(v.visit->focus());
    v.key(view::Key::next);
  }
  EXPECT_EQ(seen.size(), all);
  EXPECT_EQ(seen.count(""), 0u);
  const std::string at = v.visit->focus();
  v.key(view::Key::previous);
  EXPECT_NE(v.visit->focus(), at);
  v.key(view::Key::next);
  EXPECT_EQ(v.visit->focus(), at);
  for (std::size_t n = before; n < v.wheel_commands.hands.size(); ++n)
    EXPECT_FALSE(v.wheel_commands.hands[n].active);
  ASSERT_TRUE(v.key_to("throw.ask.4"));
  v.frames(1);
  EXPECT_TRUE(v.visit->reading().working);
}

TEST(StrokeBoard, StandsWholeOnEverySizeInEitherLanguage) {
  for (const auto& [width, height] :
       {std::pair{1280, 720}, {1920, 1080}, {1080, 1920}, {1024, 600}})
    for (const bool korean : {false, true}) {
      Visitor v(9, nullptr, true);
      v.width = width;
      v.height = height;
      v.exhibit.screen.one_switch = true;
      v.show();
      if (korean) v.speak("ko");
      v.throw_a_pot();
      v.frames(1);
      check_layout(v, v.plain, "strokes by buttons");
      v.touch("throw.tell");
      check_layout(v, v.plain, "strokes by buttons, and how it differs");
    }
}

TEST(ScreenText, EveryControlOfEveryScreenHasANameAndEveryPageHasWords) {
  for (const bool aided : {false, true}) {
    Visitor v(9, nullptr, true);
    v.exhibit.screen.spoken = aided;
    v.show();
    walk(v, [&](const std::string& name) {
      const ScreenText reading = v.visit->reading();
      EXPECT_FALSE(reading.words.empty()) << name;
      EXPECT_FALSE(reading.controls.empty()) << name;
      for (const Control& c : reading.controls) {
        EXPECT_FALSE(c.words.empty()) << name << " " << c.id;
        EXPECT_EQ(c.words.find('['), std::string::npos) << c.words;
      }
    });
  }
}

TEST(ScreenText, IsInTheOrderOfThePageAndWhatIsOnIsSaid) {
  Visitor v;
  v.touch("comfort");
  v.touch("comfort.high_contrast");
  const ScreenText reading = v.visit->reading();
  EXPECT_EQ(reading.over, "comfort");
  EXPECT_EQ(find(reading, "comfort.high_contrast")->on, std::optional(true));
  EXPECT_EQ(find(reading, "comfort.larger_text")->on, std::optional(false));
  EXPECT_EQ(reading.controls.back().id, "language") << "at the foot of the page";
  ASSERT_GE(reading.words.size(), 2u);
  EXPECT_EQ(reading.words.front(), "Accessibility");
}

TEST(Comfort, ThePaceOfTheSwitchIsChosenInStepsFromHalfASecondToFive) {
  Visitor v;
  v.touch("comfort");
  EXPECT_FALSE(v.visit->control("comfort.slower"));
  v.touch("comfort.one_switch");
  EXPECT_EQ(v.visit->shown_on().scan_seconds, 1.5);
  v.touch("comfort.slower");
  EXPECT_EQ(v.visit->shown_on().scan_seconds, 2.0);
  for (int n = 0; n < 9; ++n) v.touch("comfort.slower");
  EXPECT_EQ(v.visit->shown_on().scan_seconds, 5.0);
  for (int n = 0; n < 12; ++n) v.touch("comfort.faster");
  EXPECT_EQ(v.visit->shown_on().scan_seconds, 0.5);
}

TEST(Idle, WhoHasOneSwitchHasTheTimeToComeRoundToEverything) {
  for (const bool slow : {false, true}) {
    Visitor v;
    v.exhibit.screen.one_switch = slow;
    v.exhibit.screen.scan_seconds = 5;
    v.show();
    v.throw_a_pot();
    v.frames(v.exhibit.idle.warn_after + 2);
    EXPECT_EQ(v.visit->idle_warning(), !slow);
    v.frames(slow ? 40 * 5.0 : 0.1);
    EXPECT_TRUE(v.visit->idle_warning());
    v.frames(v.exhibit.idle.countdown + 2);
    EXPECT_EQ(v.visit->screen() == ScreenId::attract, !slow);
    v.frames(10 * 5.0);
    EXPECT_EQ(v.visit->screen(), ScreenId::attract);
  }
}

TEST(StrokeBoard, ItsButtonsFillTheirRowsAndNoneStandsAloneInAnyLanguage) {
  const render::Typesetter fonts;
  std::vector<content::Language> all{long_words(), from_the_right()};
  for (const auto& file : std::filesystem::directory_iterator("content/languages"))
    all.push_back(*content::Language::read(file.path()));
  int in_two_rows = 0;
  for (const content::Language& language : all)
    for (const auto& [width, height] :
         {std::pair(1280, 720), {1920, 1080}, {1080, 1920}, {1024, 600}})
      for (const bool larger : {false, true}) {
        Visitor v(3, &fonts);
        v.width = width, v.height = height;
        v.languages = {language, v.languages.front()};
        v.exhibit.screen.spoken = true;
        v.exhibit.screen.larger_text = larger;
        v.put_tools_to_hand();
        v.throw_a_pot();
        v.frames(1);
        std::map<float, std::map<std::string, int>> rows;  // by height: how many of each kind
        float left = 1e9f, right = 0;
        for (const auto& [id, rect] : v.visit->controls()) {
          const bool stroke = id.starts_with("throw.ask.") || id == "throw.tell";
          const bool way = id == "throw.tools" || id == "throw.wheel";
          if (!stroke && !way && !id.starts_with("throw.part.")) continue;
          ++rows[rect.y][stroke || way ? "strokes and ways" : "parts"];
          left = std::min(left, rect.x), right = std::max(right, rect.x + rect.w);
        }
        for (const auto& [id, rect] : v.visit->controls()) {
          if (id != "throw.tell") continue;
          const int beside = rows[rect.y]["strokes and ways"];
          EXPECT_GT(beside, 1) << language.code() << ' ' << width << (larger ? " larger" : "");
          in_two_rows += rows.size() > 3 ? 1 : 0;
        }
        // Every row reaches from one side to the other.
        for (const auto& [y, kinds] : rows) {
          float from = 1e9f, to = 0;
          for (const auto& [id, rect] : v.visit->controls())
            if (rect.y == y) from = std::min(from, rect.x), to = std::max(to, rect.x + rect.w);
          EXPECT_NEAR(from, left, 1)
              << language.code() << ' ' << width << (larger ? " larger" : "");
          EXPECT_NEAR(to, right, 1) << language.code() << ' ' << width << (larger ? " larger" : "");
        }
      }
  EXPECT_GT(in_two_rows, 10) << "where they do not fit in one each";
}

}  // namespace
}  // namespace onggi::screens::stroke_board_test
