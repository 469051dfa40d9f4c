#include "kiosk/exhibit/rehearsal/naive_hands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace onggi::rehearsal::naive_hands_test {
namespace {

using view::InputEvent;

// A vase to be met, a cylinder on the wheel, and a screen that shows both.
struct Wheel {
  Profile target, made;
  screens::WheelSnapshot sight;
  Wheel() {
    for (int i = 0; i <= 100; ++i) {
      const double h = 0.002 * i;
      target.points.push_back({h, 0.04 + 0.02 * std::sin(12.0 * h), h < 0.01 ? 0.0 : 0.03});
      made.points.push_back({h, 0.055, h < 0.01 ? 0.0 : 0.022});
    }
    sight.camera = view::frame_pot(1280, 720, {640, 0, 640, 720}, 0.2, 0.08);
    sight.target = &target;
    sight.made = &made;
    sight.hint = {"hint.press_in", "place.belly", screens::Hint::Press{0.1, true}};
  }
};

struct Seen {
  int strokes = 0, moves = 0;
  double fastest = 0;  // px/s between two frames of one stroke
  double least_x = 1e9, most_x = -1e9, least_y = 1e9, most_y = -1e9;
  std::set<std::string> controls;
  double first_touch = -1, done_at = -1;
  std::string all;  // to compare two runs
};

Seen watch(NaiveHands& hands, Wheel& wheel, double seconds) {
  Seen seen;
  bool down = false;
  float x = 0, y = 0;
  for (int n = 0; n * 0.02 < seconds && !hands.done(); ++n) {
    const double now = n * 0.02;
    const NaiveHands::Move move = hands.step(now, wheel.sight, 1280);
    for (const InputEvent& e : move.events) {
      seen.all += std::to_string(static_cast<int>(e.kind)) + " " + std::to_string(e.x) + " " +
                  std::to_string(e.y) + "\n";
      if (e.kind == InputEvent::Kind::pointer_down) {
        EXPECT_FALSE(down) << "a finger that is down cannot go down";
        down = true;
        ++seen.strokes;
        if (seen.first_touch < 0) seen.first_touch = now;
      } else {
        EXPECT_TRUE(down) << "a finger that is up neither moves nor is lifted";
      }
      if (e.kind == InputEvent::Kind::pointer_move) {
        ++seen.moves;
        seen.fastest = std::max(seen.fastest, std::hypot(e.x - x, e.y - y) / 0.02);
      }
      if (e.kind == InputEvent::Kind::pointer_up) down = false;
      x = e.x;
      y = e.y;
      seen.least_x = std::min(seen.least_x, double{x});
      seen.most_x = std::max(seen.most_x, double{x});
      seen.least_y = std::min(seen.least_y, double{y});
      seen.most_y = std::max(seen.most_y, double{y});
    }
    if (!move.control.empty()) {
      EXPECT_FALSE(down) << "a button is touched by a finger that was lifted";
      seen.controls.insert(move.control);
      seen.done_at = now;
    }
  }
  EXPECT_FALSE(down);
  return seen;
}

class EverySeed : public testing::TestWithParam<int> {};

TEST_P(EverySeed, TheyMakeStrokesOnThePotAndThenCallItDone) {
  for (const auto pointer : {NaiveHands::Pointer::mouse, NaiveHands::Pointer::finger}) {
    Wheel wheel;
    NaiveHands hands(static_cast<std::uint64_t>(GetParam()), 60, pointer);
    const Seen seen = watch(hands, wheel, 90);
    EXPECT_TRUE(hands.done());
    EXPECT_GT(seen.first_touch, 0.4);
    EXPECT_LT(seen.first_touch, 6.0);
    EXPECT_GE(seen.strokes, 6);
    EXPECT_LE(seen.strokes, 60);
    EXPECT_EQ(seen.controls, std::set<std::string>{"throw.done"});
    EXPECT_GE(seen.done_at, 60.0);
    EXPECT_LT(seen.done_at, 80.0);  // a stroke that was begun is ended
    // Within the half of the screen where the pot is, and no faster than hurried hands.
    EXPECT_GT(seen.least_x, 640);
    EXPECT_LT(seen.most_x, 1280);
    EXPECT_GT(seen.least_y, 0);
    EXPECT_LT(seen.most_y, 720);
    EXPECT_LT(seen.fastest, 1500);
  }
}
INSTANTIATE_TEST_SUITE_P(NaiveHands, EverySeed, testing::Range(1, 21),
                         [](const auto& seed) { return "seed_" + std::to_string(seed.param); });

TEST(NaiveHands, TheSameSeedMakesTheSameStrokesAndAnotherOnesOthers) {
  const auto strokes = [](std::uint64_t seed) {
    Wheel wheel;
    NaiveHands hands(seed, 20, NaiveHands::Pointer::mouse);
    return watch(hands, wheel, 60).all;
  };
  EXPECT_EQ(strokes(3), strokes(3));
  EXPECT_NE(strokes(3), strokes(4));
}

TEST(NaiveHands, AskedForTheOtherSideTheyTouchItsButtonAfterAMoment) {
  Wheel wheel;
  wheel.sight.hint = {"hint.go_inside", "place.belly", screens::Hint::Press{0.1, false}};
  NaiveHands hands(5, 60, NaiveHands::Pointer::mouse);
  const Seen seen = watch(hands, wheel, 90);
  EXPECT_EQ(seen.controls.count("throw.inside"), 1u);
}

TEST(NaiveHands, TheirTremorIsOfPixelsNotOfCentimetres) {
  // Strokes along the line, by many people, stay within a finger's breadth of it for most of their
  // way.
  int near = 0, all = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Wheel wheel;
    NaiveHands hands(seed, 60, NaiveHands::Pointer::mouse);
    int strokes = 0;
    for (int n = 0; n < 4500 && strokes <= 2; ++n) {
      for (const InputEvent& e : hands.step(n * 0.02, wheel.sight, 1280).events) {
        if (e.kind == InputEvent::Kind::pointer_down) ++strokes;
        if (e.kind != InputEvent::Kind::pointer_move || strokes > 2) continue;
        const Vec2 at = wheel.sight.camera.on_axis_plane(e.x, e.y);
        ++all;
        near += std::fabs(std::fabs(at.x) - wheel.target.outer_at(at.y)) < 0.004;
      }
    }
  }
  ASSERT_GT(all, 2000);
  EXPECT_GT(near, 0.9 * all) << near << " of " << all;
}

TEST(NaiveHands, HoldACoilNearlyStillOnTheRim) {
  Wheel wheel;
  wheel.sight.hint = {"hint.lay_coil", {}, {}};
  const auto rim = *wheel.sight.camera.project({0.055, 0.2, 0});
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    NaiveHands hands(seed, 60, NaiveHands::Pointer::mouse);
    const Seen seen = watch(hands, wheel, 90);
    EXPECT_LT(seen.strokes, 22) << "three to nine seconds each";
    EXPECT_GT(seen.least_y, rim.second - 40);
    EXPECT_LT(seen.most_y, rim.second + 40);
  }
}

TEST(NaiveHands, BeatWhereTheArrowIsMoreOftenThanElsewhere) {
  Wheel wheel;
  wheel.sight.hint = {"hint.beat", {}, screens::Hint::Press{0.18, true}};
  int above = 0, all = 0;
  const auto middle = *wheel.sight.camera.project({0.0, 0.12, 0});
  for (std::uint64_t seed = 1; seed < 9; ++seed) {
    NaiveHands hands(seed, 60, NaiveHands::Pointer::mouse);
    for (int n = 0; n < 2900; ++n)
      for (const InputEvent& e : hands.step(0.02 * n, wheel.sight, 1280).events) {
        above += e.y < middle.second;
        ++all;
      }
  }
  EXPECT_GT(above, 0.6 * all);
  EXPECT_LT(above, 0.98 * all);
}

TEST(NaiveHands, TakeTheToolThatTheHintNamesAndCallAGoodPotDone) {
  Wheel wheel;
  wheel.sight.hint = {"hint.take_paddle", "throw.tools", {}};
  wheel.sight.tool = "throw.tool.2";
  NaiveHands hands(4, 60, NaiveHands::Pointer::mouse);
  const Seen asked = watch(hands, wheel, 90);
  EXPECT_TRUE(asked.controls.contains("throw.tools"));
  EXPECT_TRUE(asked.controls.contains("throw.tool.2"));
  Wheel good;
  good.sight.hint = {"hint.beaten", {}, {}};
  NaiveHands happy(4, 60, NaiveHands::Pointer::mouse);
  const Seen done = watch(happy, good, 90);
  EXPECT_TRUE(done.controls.contains("throw.done"));
  EXPECT_LT(done.done_at, 55);
}

}  // namespace
}  // namespace onggi::rehearsal::naive_hands_test
