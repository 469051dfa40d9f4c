#include "kiosk/visit/screens/two_hands.h"

#include <gmock/gmock.h>

#include "kiosk/picture/render/text.h"
#include "tests/kiosk/visit/screens/layout_check.h"
#include "tests/kiosk/visit/screens/visitor.h"

// Two visitors at one wheel, and a pot that nobody sees.

namespace onggi::screens::two_hands_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using view::InputEvent;
using view::Key;
using Kind = InputEvent::Kind;

settings::Mission mission(settings::Mission::Kind kind) {
  settings::Mission one;
  one.id = "it";
  one.kind = kind;
  one.title = {{"en", "A mission"}};
  one.about = {{"en", "What there is to do."}};
  return one;
}

/// At the wheel with the mission, of the shelf's first vessel.
struct AtWheel : Visitor {
  explicit AtWheel(settings::Mission::Kind kind) {
    put_on(mission(kind), 0);
    touch("attract.begin");
    touch("choose.mission.0");
    touch("choose.throw");
    frames(1);
    wheel_commands.hands.clear();
  }
  /// Where `x` right of the axis at the height `y` is on the screen; m.
  std::pair<float, float> at(double x, double y) const {
    Vec3 right, up, back;
    const view::Camera camera = visit->sight()->camera;
    camera.basis(right, up, back);
    const auto px = camera.project({right.x * x, y, right.z * x});
    return {px->first, px->second};
  }
  void finger(int which, Kind kind, double x, double y) {
    const auto [px, py] = at(x, y);
    InputEvent e{kind, px, py, 0, Key::none, false};
    e.glass = true;
    e.finger = static_cast<std::uint8_t>(which);
    visit->input(e, now);
  }
  /// Hand 0 and 1 as the wheel was told last.
  std::array<HandInput, 2> told() {
    show();
    const auto& all = wheel_commands.hands;
    return {all[all.size() - 2], all[all.size() - 1]};
  }
};
constexpr auto kTwo = settings::Mission::Kind::two_hands;
constexpr auto kDarkOne = settings::Mission::Kind::eyes_closed;

TEST(TwoHands, AFingerOnEachHalfIsAHandEachAndBothWorkAtOnce) {
  AtWheel v(kTwo);
  v.finger(0, Kind::pointer_down, 0.06, 0.12);
  auto hands = v.told();
  EXPECT_TRUE(hands[0].active);
  EXPECT_FALSE(hands[1].active);
  EXPECT_EQ(hands[0].side, SideWish::outside);
  v.finger(1, Kind::pointer_down, -0.05, 0.06);
  hands = v.told();
  EXPECT_TRUE(hands[0].active && hands[1].active);
  EXPECT_EQ(hands[1].side, SideWish::inside);
  EXPECT_NEAR(hands[0].position.y, 0.12, 0.02) << "each at a height of its own";
  EXPECT_NEAR(hands[1].position.y, 0.06, 0.02);
  // On opposite sides of the axis.
  EXPECT_LT(hands[0].position.x * hands[1].position.x + hands[0].position.z * hands[1].position.z,
            0);
}

TEST(TwoHands, WhoLiftsLiftsOwnHandAndTheOthersGoesOn) {
  AtWheel v(kTwo);
  v.finger(0, Kind::pointer_down, 0.06, 0.12);
  v.finger(1, Kind::pointer_down, -0.05, 0.06);
  v.show();
  v.finger(0, Kind::pointer_up, 0.06, 0.12);
  v.frames(6);
  auto hands = v.told();
  EXPECT_FALSE(hands[0].active);
  EXPECT_TRUE(hands[1].active);
  // The next finger is called 0 again, and is whoever's half it is on.
  v.finger(0, Kind::pointer_down, 0.06, 0.1);
  hands = v.told();
  EXPECT_TRUE(hands[0].active && hands[1].active);
}

TEST(TwoHands, ASecondFingerOnTheSameHalfRestsAndWhoeverComesFirstMayBeInside) {
  AtWheel v(kTwo);
  v.finger(0, Kind::pointer_down, -0.05, 0.1);
  v.finger(1, Kind::pointer_down, -0.05, 0.15);
  auto hands = v.told();
  EXPECT_FALSE(hands[0].active);
  EXPECT_TRUE(hands[1].active);
  EXPECT_NEAR(hands[1].position.y, 0.1, 0.02);
  v.finger(1, Kind::pointer_up, -0.05, 0.15);
  v.frames(6);
  EXPECT_TRUE(v.told()[1].active) << "it was not that finger's";
}

TEST(TwoHands, AMouseAndArrowsAreTwoHandsToo) {
  AtWheel v(kTwo);
  const auto [x, y] = v.at(0.06, 0.1);
  v.down(x, y);
  v.key(Key::up);
  auto hands = v.told();
  EXPECT_TRUE(hands[0].active && hands[1].active);
  EXPECT_EQ(hands[1].side, SideWish::inside);
  const double before = hands[1].position.y;
  for (int n = 0; n < 8; ++n) v.key(Key::up);
  v.frames(1);
  hands = v.told();
  EXPECT_GT(hands[1].position.y, before + 0.008);
  EXPECT_NEAR(hands[0].position.y, 0.1, 0.02);
}

TEST(TwoHands, TheMouseTakesNothingFromTheKeyboardAmongTheButtons) {
  AtWheel v(kTwo);
  v.key(Key::up);
  v.frames(0.5);
  v.key(Key::enter);
  EXPECT_EQ(v.visit->focus(), "throw.done");
  const auto [x, y] = v.at(0.06, 0.1);
  const auto mouse_works = [&, from = x, high = y](float by) {
    v.down(from, high);
    v.show();
    v.move(from + by, high);
    v.frames(0.2);
  };
  mouse_works(-4);
  EXPECT_EQ(v.visit->focus(), "throw.done") << "whoever is there stays";
  EXPECT_TRUE(v.told()[0].active && v.told()[1].active) << "and both hands work on";
  ASSERT_TRUE(v.key_to("throw.water"));
  EXPECT_TRUE(v.wheel_commands.waters.back());
  ASSERT_TRUE(v.key_to("throw.wheel"));
  ASSERT_TRUE(v.visit->control("throw.faster"));
  v.up(x - 4, y);
  mouse_works(-8);
  ASSERT_TRUE(v.visit->control("throw.faster")) << "nor is their drawer closed";
  const double before = v.wheel_commands.wheels.back();
  ASSERT_TRUE(v.key_to("throw.faster"));
  EXPECT_GT(v.wheel_commands.wheels.back(), before);
  v.key(Key::back);
  v.key(Key::back);
  EXPECT_EQ(v.visit->focus(), "") << "the arrows move the hand again";
  const double high = v.told()[1].position.y;
  for (int n = 0; n < 6; ++n) v.key(Key::up);
  v.frames(1);
  EXPECT_GT(v.told()[1].position.y, high + 0.005);
}

TEST(TwoHands, ADrawerThatTheMouseOpenedIsClosedByItsTouchOfThePot) {
  AtWheel v(kTwo);
  v.touch("throw.wheel");
  ASSERT_TRUE(v.visit->control("throw.faster"));
  const auto [x, y] = v.at(0.06, 0.1);
  v.down(x, y);
  v.show();
  EXPECT_FALSE(v.visit->control("throw.faster"));
}

TEST(TwoHands, OfOneVisitorThePointerTakesTheKeyboardOutOfTheButtons) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  v.key(Key::enter);
  EXPECT_EQ(v.visit->focus(), "throw.show");
  v.move(900, 300);
  v.show();
  EXPECT_EQ(v.visit->focus(), "");
  v.key(Key::up);
  EXPECT_EQ(v.visit->focus(), "") << "the arrows move the hand";
  v.exhibit.screen.spoken = true;  // and where keys move among buttons only
  v.key(Key::up);
  EXPECT_NE(v.visit->focus(), "");
  v.move(900, 310);
  v.show();
  EXPECT_EQ(v.visit->focus(), "");
}

TEST(TwoHands, AnArrowMovesTheHandInsideToTheSideThatItPointsTo) {
  for (const bool left_handed : {false, true}) {
    AtWheel v(kTwo);
    v.exhibit.screen.left_handed = left_handed;
    v.frames(1);
    Vec3 right, up, back;
    v.visit->sight()->camera.basis(right, up, back);
    const auto x = [&] { return dot(right, v.told()[1].position); };
    v.key(Key::up);
    v.frames(0.5);
    double before = x();
    EXPECT_LT(before, 0) << "it is on the left half";
    for (int n = 0; n < 6; ++n) v.key(Key::left);
    v.frames(0.5);
    EXPECT_LT(x(), before - 0.002);
    before = x();
    for (int n = 0; n < 6; ++n) v.key(Key::right);
    v.frames(0.5);
    EXPECT_GT(x(), before + 0.002);
  }
}

TEST(TwoHands, WithAKeyboardItIsSaidWhoseHandTheArrowsAre) {
  for (const bool keys : {false, true}) {
    Visitor v;
    settings::Mission two = mission(kTwo);
    if (keys) two.second = settings::Mission::Second::keys;
    v.put_on(two, 0);
    v.touch("attract.begin");
    v.touch("choose.mission.0");
    v.frames(1);
    EXPECT_EQ(words_in(v.frame).find("The arrow keys move the inside hand.") != std::string::npos,
              keys);
    v.touch("choose.throw");
    v.frames(1);
    EXPECT_EQ(words_in(v.frame).find("The arrow keys move the inside hand.") != std::string::npos,
              keys);
    EXPECT_EQ(words_in(v.frame).find("left half") != std::string::npos, !keys);
  }
}

TEST(TwoHands, WithoutTheMissionTwoFingersAreBothHandsOfOneVisitor) {
  Visitor v;
  v.throw_a_pot();
  v.frames(1);
  EXPECT_FALSE(v.visit->reading().words.empty());
  EXPECT_THAT(words_in(v.frame), Not(HasSubstr("left half")));
}

TEST(TwoHands, SaysWhoseHalfIsWhoseAndTheResultIsBoths) {
  AtWheel v(kTwo);
  EXPECT_THAT(words_in(v.frame), HasSubstr("the left half: the inside hand works."));
  EXPECT_FALSE(v.visit->control("throw.show")) << "that is done by both hands of one";
  v.touch("throw.done");
  v.frames(1);
  EXPECT_THAT(words_in(v.frame), HasSubstr("A mission: Panathenaic amphora"));
}

TEST(TwoHands, WhoHasStrokesByButtonsIsToldThatBothHandsMakeThem) {
  for (const bool one_switch : {false, true}) {
    Visitor v;
    v.put_on(mission(kTwo), 0);
    v.exhibit.screen.one_switch = one_switch;
    v.show();
    const auto press = [&](const char* control) {
      v.visit->activate(control, v.now);
      v.frames(0.5);
    };
    press("attract.begin");
    press("choose.mission.0");
    constexpr const char* kBoth = "The buttons move both hands together";
    EXPECT_EQ(words_in(v.frame).find(kBoth) != std::string::npos, one_switch);
    press("choose.throw");
    v.frames(1);
    EXPECT_EQ(words_in(v.frame).find(kBoth) != std::string::npos, one_switch);
    EXPECT_EQ(words_in(v.frame).find("left half") == std::string::npos, one_switch);
    if (!one_switch) continue;
    press("throw.ask.4");
    v.frames(30);
    EXPECT_EQ(words_in(v.frame).find(kBoth), std::string::npos) << "who has begun knows it";
  }
}

TEST(EyesClosed, ThePotAndItsLineAreNotShownAndTheScreenIsDark) {
  AtWheel v(kDarkOne);
  EXPECT_FALSE(v.frame.pot);
  const auto* ground = std::get_if<view::Box>(&v.frame.items.front());
  ASSERT_NE(ground, nullptr);
  EXPECT_EQ(ground->rect.w, static_cast<float>(v.width));
  for (const view::Item& item : v.frame.items) {
    const auto* line = std::get_if<view::Line>(&item);
    if (line == nullptr) continue;
    for (const auto& [x, y] : line->points)
      EXPECT_LT(x, 0.4f * static_cast<float>(v.width)) << "nothing of any outline";
  }
  EXPECT_THAT(words_in(v.frame), HasSubstr("Push out there")) << "words say how it goes";
  EXPECT_THAT(words_in(v.frame), HasSubstr("empty part of the screen")) << "and where";
  EXPECT_TRUE(v.visit->control("back"));
  EXPECT_TRUE(v.visit->control("throw.done"));
  EXPECT_FALSE(v.visit->control("throw.show"));
}

TEST(EyesClosed, WhatIsNeverThereLeavesNoHoleAmongTheButtons) {
  for (const auto kind : {kDarkOne, kTwo}) {
    AtWheel v(kind);
    v.status.can_restore = true;
    v.show();
    // Water, done and step back: in one row, or the first two in one and the last below the first.
    const auto water = *v.visit->control("throw.water"), done = *v.visit->control("throw.done"),
               restore = *v.visit->control("throw.restore");
    EXPECT_EQ(water.y, done.y);
    EXPECT_TRUE(restore.y == water.y || restore.x == water.x);
  }
}

TEST(MissionHelp, SpeaksOfTheMissionAndOfNoLineWhereNoneIsSeen) {
  for (const auto& [kind, about, two, line] :
       {std::tuple(kDarkOne, true, true, false), {kTwo, true, false, true}}) {
    AtWheel v(kind);
    v.touch("help");
    v.show();
    const std::string words = words_in(v.frame);
    EXPECT_EQ(words.find("What there is to do.") != std::string::npos, about) << words;
    EXPECT_EQ(words.find("Two hands, one inside") != std::string::npos, two) << words;
    EXPECT_EQ(words.find("red and thick") != std::string::npos, line) << words;
  }
  Visitor usual;
  usual.throw_a_pot();
  usual.touch("help");
  const std::string words = words_in(usual.frame);
  EXPECT_NE(words.find("Two hands, one inside"), std::string::npos) << words;
  EXPECT_NE(words.find("red and thick"), std::string::npos) << words;
}

TEST(EyesClosed, AFingerWorksOnThePotThatIsNotSeen) {
  AtWheel v(kDarkOne);
  v.finger(0, Kind::pointer_down, 0.06, 0.1);
  EXPECT_TRUE(v.told()[0].active);
}

TEST(EyesClosed, IsReadAloudWhatTheComfortPageSaysAndStrokesAreStillDrawn) {
  AtWheel v(kDarkOne);
  EXPECT_FALSE(v.visit->shown_on().spoken);
  EXPECT_TRUE(v.visit->spoken());
  EXPECT_TRUE(v.visit->reading().spoken);
  EXPECT_TRUE(v.visit->reading().unasked);
  EXPECT_FALSE(v.visit->control("throw.part.2"));
  v.touch("throw.done");
  v.frames(1);
  EXPECT_FALSE(v.visit->spoken()) << "the eyes are open";
}

TEST(EyesClosed, EveryStrokeAsksHowThePotDiffers) {
  AtWheel v(kDarkOne);
  for (int strokes = 1; strokes <= 2; ++strokes) {
    v.finger(0, Kind::pointer_down, 0.06, 0.1);
    v.frames(1);
    EXPECT_EQ(v.visit->reading().asked, strokes - 1) << "not while hands are at work";
    v.finger(0, Kind::pointer_up, 0.06, 0.1);
    v.frames(6);
    EXPECT_EQ(v.visit->reading().asked, strokes);
    EXPECT_FALSE(v.visit->reading().differences.empty());
  }
}

TEST(EyesClosed, TheResultShowsThePotBesideTheVessel) {
  AtWheel v(kDarkOne);
  v.touch("throw.done");
  v.frames(1);
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
  ASSERT_TRUE(v.frame.pot);
  EXPECT_TRUE(v.frame.pot->beside);
}

TEST(MissionsOfHandsAndEyes, LoseNoWordInAnySizeOrLanguageAndAreLegibleInTheDark) {
  const render::Typesetter fonts;
  for (const auto& [width, height] : {std::pair{1280, 720}, {1080, 1920}})
    for (const auto kind : {kTwo, kDarkOne})
      for (const char* language : {"en", "de", "ar", "ja"})
        for (const bool larger : {false, true}) {
          SCOPED_TRACE(std::to_string(width) + " " + language);
          Visitor v(9, &fonts, true);
          v.languages.insert(
              v.languages.begin(),
              *content::Language::read(std::string("content/languages/") + language + ".toml"));
          v.width = width;
          v.height = height;
          v.exhibit.screen.larger_text = larger;
          v.put_on(mission(kind), 0);
          v.touch("attract.begin");
          v.touch("choose.mission.0");
          v.touch("choose.throw");
          v.frames(1);
          check_layout(v, fonts, "throw");
          v.touch("throw.wheel");
          v.frames(1);
          check_layout(v, fonts, "drawer");
        }
}

}  // namespace
}  // namespace onggi::screens::two_hands_test
