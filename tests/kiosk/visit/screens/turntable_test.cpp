#include "kiosk/visit/screens/turntable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kiosk/picture/view/palette.h"
#include "tests/kiosk/visit/screens/visitor.h"

// Whoever has keys or one switch looks at the pot from all sides, too.

namespace onggi::screens::turntable_test {
namespace {

using view::InputEvent;
using view::Key;

constexpr const char* kPots = "result.turn";

/// The result as it is laid out for right hands, left hands, and words from the right.
enum class Laid { usual, left_handed, from_right };
constexpr Laid kLaid[] = {Laid::usual, Laid::left_handed, Laid::from_right};

struct AtResult : Visitor {
  explicit AtResult(Laid laid = Laid::usual, bool of_description = false)
      : Visitor(3, nullptr, true) {
    exhibit.screen.left_handed = laid == Laid::left_handed;
    if (laid == Laid::from_right)
      languages.insert(languages.begin(), *content::Language::read("content/languages/ar.toml"));
    if (of_description) {
      put_on(described(1.0));
      touch("attract.begin");
      touch("choose.mission.0");
      touch("choose.throw");
      frames(1);
      touch("throw.done");
    } else {
      make_result();
    }
    frames(1);
  }
  double angle() const { return frame.pot->clay_angle; }
  /// By how much the pot turned in what `act` did, the short way round.
  template <class Act>
  double turned(Act&& act) {
    const double before = angle();
    act();
    return std::remainder(angle() - before, 6.283185307179586);
  }
  /// Arrows alone, until the keyboard is on the pots.
  bool go_to_pots() {
    for (const Key arrow : {Key::up, Key::right, Key::left, Key::up, Key::up, Key::up, Key::up})
      if (visit->focus() != kPots) key(arrow);
    return visit->focus() == kPots;
  }
  bool ringed() const {
    const view::Rect at = *visit->control(kPots);
    for (const view::Item& item : frame.items)
      if (const auto* box = std::get_if<view::Box>(&item))
        if (box->border > 2 && box->border_color == view::kInk && box->rect.x < at.x &&
            box->rect.w > at.w && box->rect.w < 1.1f * at.w && box->rect.y < at.y)
          return true;
    return false;
  }
};

TEST(Turntable, ArrowsTurnBothPotsTheWayThatAFingerDoesInEveryLayout) {
  for (const Laid laid : kLaid) {
    SCOPED_TRACE(static_cast<int>(laid));
    AtResult v(laid);
    v.exhibit.screen.reduced_motion = true;
    ASSERT_TRUE(v.go_to_pots());
    EXPECT_TRUE(v.ringed());
    const double beside = v.frame.pot->beside->angle;
    const double right = v.turned([&] { v.key(Key::right); });
    EXPECT_NEAR(std::abs(right), 3.14159 / 18, 1e-4);
    EXPECT_NEAR(v.frame.pot->beside->angle - beside, right, 1e-9) << "together";
    EXPECT_NEAR(v.turned([&] { v.key(Key::left); }), -right, 1e-9);
    EXPECT_EQ(v.visit->focus(), kPots);
    const view::Rect at = *v.visit->control(kPots);
    const float x = at.x + at.w / 2, y = at.y + at.h / 2;
    const double dragged = v.turned([&] {
      v.down(x, y);
      v.move(x + 30, y);
      v.show();
      v.up(x + 30, y);
      v.show();
    });
    EXPECT_GT(dragged * right, 0);
    EXPECT_EQ(v.visit->screen(), ScreenId::result) << "a finger there presses nothing";
    EXPECT_FALSE(v.ringed()) << "a finger needs no ring";
  }
}

TEST(Turntable, TheFrameRoundThePotsCrossesNeitherWordNorLine) {
  for (const Laid laid : kLaid)
    for (const auto& [width, height] : {std::pair{1280, 720}, {1024, 600}, {1080, 1920}}) {
      AtResult v(laid);
      v.width = width, v.height = height;
      v.frames(1);
      ASSERT_TRUE(v.go_to_pots());
      const view::Rect at = *v.visit->control(kPots);
      const auto ring =
          std::find_if(v.frame.items.begin(), v.frame.items.end(), [&](const auto& i) {
            const auto* box = std::get_if<view::Box>(&i);
            return box != nullptr && box->border > 2 && box->rect.w > at.w && box->rect.y < at.y;
          });
      ASSERT_NE(ring, v.frame.items.end());
      const view::Rect frame = std::get<view::Box>(*ring).rect;
      for (const view::Item& item : v.frame.items) {
        if (const auto* text = std::get_if<view::Text>(&item)) {
          EXPECT_FALSE(frame.contains(text->box.x + text->box.w / 2, text->box.y)) << text->text;
        }
        if (const auto* line = std::get_if<view::Line>(&item)) {
          for (const auto& [x, y] : line->points)
            EXPECT_FALSE(frame.contains(x, y)) << width << "x" << height;
        }
      }
    }
}

TEST(Turntable, AnArrowThatIsHeldTurnsAsOftenAsItRepeatsHoweverSeldomThereIsAFrame) {
  AtResult v;
  ASSERT_TRUE(v.go_to_pots());
  const double by = v.turned([&] {
    for (int n = 0; n < 9; ++n)
      v.visit->input({InputEvent::Kind::key_down, 0, 0, 0, Key::right, n > 0}, v.now);
    v.show();
  });
  EXPECT_NEAR(std::abs(by), 3.14159 / 2, 1e-4);
}

TEST(Turntable, UpAndDownAndTabGoOnFromThePotsInEveryLayout) {
  for (const Laid laid : kLaid)
    for (const auto& [width, height] : {std::pair{1280, 720}, {1080, 1920}})
      for (const Key arrow : {Key::up, Key::down, Key::next, Key::previous}) {
        SCOPED_TRACE(std::to_string(width) + " " + std::to_string(static_cast<int>(arrow)));
        AtResult v(laid);
        v.width = width, v.height = height;
        v.frames(1);
        ASSERT_TRUE(v.go_to_pots());
        bool to_a_button = false;
        for (int n = 0; n < 24; ++n) {
          v.key(arrow);
          const std::string& on = v.visit->focus();
          to_a_button = to_a_button || (on.starts_with("result.") && on != kPots);
        }
        EXPECT_TRUE(to_a_button) << "nobody is caught";
      }
}

TEST(Turntable, ThePotsStandWhileTheKeyboardIsOnThemAndTurnOnWhenItHasGone) {
  AtResult v;
  EXPECT_GT(std::abs(v.turned([&] { v.frames(1); })), 0.4);
  ASSERT_TRUE(v.go_to_pots());
  EXPECT_EQ(v.turned([&] { v.frames(2); }), 0.0);
  v.key(Key::down);
  EXPECT_GT(std::abs(v.turned([&] { v.frames(1); })), 0.4);
}

TEST(Turntable, APressTurnsThemByAnEighthTheWayTheyTurnAndTheyAreLookedAtAWhile) {
  for (const bool left : {false, true}) {
    AtResult v(left ? Laid::left_handed : Laid::usual);
    const double own = v.turned([&] { v.frames(1); });
    const double by = v.turned([&] {
      v.visit->activate(kPots, v.now);
      v.show();
    });
    EXPECT_NEAR(by, std::copysign(3.14159265 / 4, own), 1e-6);
    v.move(3, 3);  // A mouse, so that the keyboard is nowhere.
    EXPECT_EQ(v.turned([&] { v.frames(Turntable::kRest - 0.2); }), 0.0);
    EXPECT_NE(v.turned([&] { v.frames(1); }), 0.0);
  }
}

TEST(Turntable, OneSwitchAndWhoIsReadToAreOfferedThemByName) {
  AtResult v;
  const auto of = [&] {
    for (const Control& c : v.visit->reading().controls)
      if (c.id == kPots) return c;
    return Control{};
  };
  EXPECT_EQ(of().words, "Turn it round");
  EXPECT_EQ(of().note, "the left and right arrows turn it");
  v.visit->activate("comfort.one_switch", v.now);
  v.frames(1);
  EXPECT_EQ(of().words, "Turn it round");
  EXPECT_EQ(of().note, "") << "who has one switch has no arrows";
}

TEST(Turntable, APotThatAnswersADescriptionIsTurnedByFingerAndKeysToo) {
  AtResult v(Laid::usual, true);
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  ASSERT_FALSE(v.frame.pot->beside);
  const double wheel = v.frame.pot->wheel_angle, clay = v.angle();
  ASSERT_TRUE(v.go_to_pots());
  EXPECT_EQ(v.turned([&] { v.frames(1); }), 0.0);
  const double right = v.turned([&] { v.key(Key::right); });
  EXPECT_NEAR(std::abs(right), 3.14159 / 18, 1e-4);
  EXPECT_NEAR(std::remainder(v.frame.pot->wheel_angle - wheel - v.angle() + clay, 6.283185307), 0,
              1e-9)
      << "it stands on its wheel";
  const view::Rect at = *v.visit->control(kPots);
  const double dragged = v.turned([&] {
    v.down(at.x + at.w / 2, at.y + at.h / 2);
    v.move(at.x + at.w / 2 + 40, at.y + at.h / 2);
    v.show();
  });
  EXPECT_GT(dragged * right, 0);
  EXPECT_EQ(v.turned([&] { v.frames(1); }), 0.0) << "a finger holds it";
}

TEST(Turntable, TwoFingersTurnItByTheirMiddleAndTiltItWithinBounds) {
  using Kind = InputEvent::Kind;
  Turntable table;
  const auto event = [&](Kind kind, int finger, float x, float y) {
    InputEvent e;
    e.kind = kind, e.x = x, e.y = y, e.finger = static_cast<std::uint8_t>(finger);
    return table.pair(e, 400);
  };
  EXPECT_FALSE(event(Kind::pointer_down, 0, 100, 100));
  EXPECT_FALSE(event(Kind::pointer_move, 0, 110, 100));
  EXPECT_TRUE(event(Kind::pointer_down, 1, 200, 100));
  EXPECT_TRUE(event(Kind::pointer_move, 0, 210, 200));
  EXPECT_TRUE(event(Kind::pointer_move, 1, 300, 200));
  EXPECT_NEAR(table.angle(), -3.14159 * 100 / 400, 1e-4);
  EXPECT_NEAR(table.tilt(), 0.5 * 3.14159 * 100 / 400, 1e-4);
  EXPECT_TRUE(table.stands(0));
  EXPECT_TRUE(event(Kind::pointer_move, 0, 210, 4000));
  EXPECT_EQ(table.tilt(), Turntable::kMostTilt);
  EXPECT_TRUE(event(Kind::pointer_move, 0, 210, -9000));
  EXPECT_EQ(table.tilt(), Turntable::kLeastTilt);
  // Theirs until both have left.
  EXPECT_TRUE(event(Kind::pointer_up, 1, 300, 200));
  EXPECT_TRUE(event(Kind::pointer_move, 0, 215, -9000));
  EXPECT_TRUE(event(Kind::pointer_up, 0, 215, -9000));
  EXPECT_FALSE(event(Kind::pointer_down, 0, 100, 100));
  table.let_go();
  EXPECT_FALSE(event(Kind::pointer_down, 1, 100, 100));
}

TEST(Turntable, AtTheResultTwoFingersTiltBothPots) {
  using Kind = InputEvent::Kind;
  AtResult v;
  const double before = v.frame.pot->camera.elevation;
  const view::Rect at = *v.visit->control(kPots);
  const auto event = [&](Kind kind, int finger, float x, float y) {
    InputEvent e;
    e.kind = kind, e.x = x, e.y = y, e.glass = true, e.finger = static_cast<std::uint8_t>(finger);
    v.visit->input(e, v.now);
  };
  for (const int finger : {0, 1})
    event(Kind::pointer_down, finger, at.x + 40.0f * static_cast<float>(finger + 1), at.y + 50);
  for (const int finger : {0, 1})
    event(Kind::pointer_move, finger, at.x + 40.0f * static_cast<float>(finger + 1), at.y + 110);
  v.show();
  EXPECT_GT(v.frame.pot->camera.elevation, before + 0.05);
  EXPECT_EQ(v.frame.pot->beside->camera.elevation, v.frame.pot->camera.elevation);
}

}  // namespace
}  // namespace onggi::screens::turntable_test
