#include "kiosk/visit/screens/lesson_line.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::lesson_line_test {
namespace {

bool says(const Visitor& v, const std::string& words) {
  return words_in(v.frame).find(words) != std::string::npos;
}

struct Learner : Visitor {
  Learner() {
    auto read = content::read_lesson("content/lessons/first_minute.toml", {"en", "ko"});
    EXPECT_TRUE(read.problems.empty());
    lesson = read.steps;
    EXPECT_EQ(lesson.size(), 5u);
    throw_a_pot();
    frames(0.1);
  }
  void meet(WallSide side = WallSide::outside) {
    status.feedback.hand[0].contact = true;
    status.feedback.hand[0].side = side;
  }
  void touch_clay(double seconds, WallSide side = WallSide::outside, double up = 0.05) {
    meet(side);
    status.hand[0].at = {0.06, up, 0};
    frames(seconds);
    status.feedback.hand[0].contact = false;
    frames(0.5);
  }
  /// The wall, half-way up, moves so far outwards from where it is.
  void push_out(double by) {
    for (int j = clay.floor_rows(); j < clay.rows(); ++j) {
      const double off = (clay.row_height(j) - 0.08) / 0.03;
      const auto moved = static_cast<float>(by * std::exp(-off * off));
      std::vector<float> outer(clay.outer(j).begin(), clay.outer(j).end());
      std::vector<float> inner(clay.inner(j).begin(), clay.inner(j).end());
      for (float& r : outer) r += moved;
      for (float& r : inner) r += moved;
      clay.shape(j, outer, inner);
    }
    frames(0.5);
  }
  /// One stroke from `low` up to `high`; the hands stay on the clay.
  void stroke_up(double low, double high) {
    meet();
    for (double h = low; h < high; h += 0.005) {
      status.hand[0].at = {0.06, h, 0};
      frames(0.1);
    }
  }
  void let_go() {
    status.feedback.hand[0] = {};
    frames(0.5);
  }
};

TEST(LessonLine, EachStepIsOverWhenTheVisitorHasDoneItAndTheNextComes) {
  Learner v;
  EXPECT_TRUE(says(v, "press a little"));
  v.touch_clay(0.5);
  EXPECT_TRUE(says(v, "press a little")) << "a brush with the hand is no touch";
  v.touch_clay(0.8);
  EXPECT_TRUE(says(v, "from the inside"));
  v.push_out(0.008);
  EXPECT_TRUE(says(v, "Pull it"));
  v.stroke_up(0.03, 0.12);
  EXPECT_TRUE(says(v, "Pull it")) << "the stroke goes on";
  v.let_go();
  EXPECT_TRUE(says(v, "Shape it"));
}

TEST(LessonLine, AHandInsideHasNotOpenedThePot) {
  Learner v;
  v.status.feedback.hand[1] = {};
  v.status.feedback.hand[1].contact = true;  // both hands are at the wall, and press it inwards
  v.status.feedback.hand[1].side = WallSide::inside;
  v.touch_clay(1.5);
  v.push_out(-0.004);
  EXPECT_TRUE(says(v, "from the inside"));
  v.push_out(0.006);
  EXPECT_TRUE(says(v, "from the inside")) << "a small way out from where it began";
  v.push_out(0.008);
  EXPECT_TRUE(says(v, "Pull it"));
}

TEST(LessonLine, AStepDoesNotEndInTheMiddleOfAStroke) {
  Learner v;
  v.touch_clay(1.2);
  v.push_out(0.008);
  ASSERT_TRUE(says(v, "Pull it"));
  v.frames(v.lesson[2].after - 2);
  v.stroke_up(0.03, 0.07);
  v.frames(4);
  EXPECT_TRUE(says(v, "Pull it")) << "its time is up, and the hands are at work";
  v.let_go();
  EXPECT_TRUE(says(v, "Shape it"));
}

TEST(LessonLine, AStrokeThatReachesTheRimIsDoneThere) {
  Learner v;
  v.touch_clay(1.2);
  v.push_out(0.008);
  ASSERT_TRUE(says(v, "Pull it"));
  v.stroke_up(0.03, v.clay.rim_height());
  EXPECT_TRUE(says(v, "Shape it"));
}

TEST(LessonLine, WhatWasDoneBeforeItsTurnIsNotAskedFor) {
  Learner v;
  v.meet();
  v.frames(0.5);
  v.push_out(0.008);
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Pull it"));
}

TEST(LessonLine, ALumpThatIsWiderThanItsVesselEverywhereIsNotToBeOpened) {
  for (const double belly : {0.03, 0.09}) {
    Learner v;
    v.shelf[0].target = jar(belly, 0.03, 0.03);  // the lump is 55 mm wide
    v.touch_clay(1.5);
    EXPECT_EQ(says(v, "from the inside"), belly > 0.055) << belly;
    EXPECT_EQ(says(v, "Pull it"), belly < 0.055) << belly;
  }
}

TEST(LessonLine, AStepStepsAsideAfterItsTime) {
  Learner v;
  v.frames(v.lesson[0].after - 1);
  EXPECT_TRUE(says(v, "press a little"));
  v.frames(2);
  EXPECT_TRUE(says(v, "from the inside"));
}

TEST(LessonLine, SkippedItDoesNotComeBackToThatVisitorButToTheNextOne) {
  Learner v;
  v.touch("throw.skip");
  v.show();
  EXPECT_FALSE(says(v, "press a little"));
  EXPECT_FALSE(v.visit->control("throw.skip"));
  v.touch("back");
  v.touch("choose.card.1");
  v.touch("choose.throw");
  v.frames(0.5);
  EXPECT_FALSE(says(v, "press a little"));
  v.touch("back");
  v.touch("back");
  ASSERT_EQ(v.visit->screen(), ScreenId::attract);
  v.throw_a_pot();
  v.frames(0.1);
  EXPECT_TRUE(says(v, "press a little"));
}

TEST(LessonLine, GoesOnAtThePotThatTheVisitorComesBackTo) {
  Learner v;
  v.touch_clay(1.2);
  ASSERT_TRUE(says(v, "from the inside"));
  v.touch("throw.done");
  v.touch("back");
  v.frames(0.5);
  EXPECT_TRUE(says(v, "from the inside"));
}

TEST(LessonLine, FreshClayBeginsItAnew) {
  const auto again = [](Learner& v) {
    v.touch("throw.done");
    v.touch("result.again");
    v.touch("leaving.go");
  };
  const auto another = [](Learner& v) {
    v.touch("back");
    v.touch("leaving.go");
    v.touch("choose.card.1");
    v.touch("choose.throw");
  };
  const auto new_clay = [](Learner& v) {
    v.touch("throw.renew");
    v.touch("throw.less");
  };
  for (const auto& fresh : std::vector<std::function<void(Learner&)>>{again, another, new_clay}) {
    Learner v;
    v.touch_clay(1.2);
    ASSERT_TRUE(says(v, "from the inside"));
    fresh(v);
    v.frames(0.5);
    EXPECT_TRUE(says(v, "press a little"));
    v.touch_clay(0.5);
    EXPECT_TRUE(says(v, "press a little")) << "what was done at other clay does not count";
  }
}

TEST(LessonLine, DoesNotBeginAnewForWhoHasFinishedIt) {
  Learner v;
  v.exhibit.idle.warn_after = 1000;
  for (const content::LessonStep& step : v.lesson) v.frames(step.after + 1);
  ASSERT_FALSE(v.visit->control("throw.skip"));
  v.touch("throw.done");
  v.touch("result.again");
  v.touch("leaving.go");
  v.frames(0.5);
  EXPECT_FALSE(says(v, "press a little"));
}

TEST(LessonLine, StrokesThatAreShownAreNotTheVisitors) {
  Learner v;
  v.touch("throw.show");
  v.meet(WallSide::inside);
  v.frames(3);
  v.status.feedback.hand[0] = {};
  v.touch("throw.show");
  v.frames(0.2);
  EXPECT_TRUE(says(v, "press a little"));
}

TEST(LessonLine, WhoComesByKeysReadsOfKeysAtOnce) {
  Visitor v;
  v.lesson = content::read_lesson("content/lessons/first_minute.toml", {"en", "ko"}).steps;
  v.key(view::Key::enter);
  v.show();
  ASSERT_TRUE(v.key_to("choose.card.0"));
  ASSERT_TRUE(v.key_to("choose.throw"));
  v.frames(0.5);
  ASSERT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_TRUE(says(v, "the hands push the clay")) << words_in(v.frame);
  v.down(900, 300);
  v.up(900, 300);
  v.show();
  EXPECT_TRUE(says(v, "press a little"));
}

// A built pot has its own lesson, and its own place in it.
struct Builder : Visitor {
  static constexpr double kTall = 12.0;  ///< The clay here has a thick wall.
  Builder() {
    build_lesson = content::read_lesson("content/lessons/building.toml", {"en", "ko"}).steps;
    EXPECT_EQ(build_lesson.size(), 5u);
    for (ShelfCard& card : shelf) {
      card.wheel.coil = 0.013;
      card.wheel.beating.emplace();
      card.wheel.floor = 0.5 * clay.rim_height();  // so that a ring is laid
      card.wheel.tools = {{0, "coil", 0.0065, 0.0065}, {0, "paddle", 0.02, 0.02}};
      set(card.target, kTall);
    }
  }
  /// A vessel `times` as high as the clay, with a wall as wide.
  void set(Profile& target, double times) const {
    const double wide = clay.mean_outer(clay.rows() - 1), high = times * clay.rim_height();
    target.points = {{0.0, wide, 0.0}, {high, wide, wide - 0.006}};
  }
  void set_all(double times) {
    for (ShelfCard& card : shelf) set(card.target, times);
  }
};

TEST(LessonLine, WhoBuildsIsLedFromTheFirstRingToTheLastBlow) {
  Builder v;
  for (ShelfCard& card : v.shelf) card.wheel.floor = v.clay.rim_height();
  v.throw_a_pot();
  v.frames(0.5);
  EXPECT_TRUE(says(v, "edge of the clay")) << words_in(v.frame);
  for (ShelfCard& card : v.shelf) card.wheel.floor = 0.5 * v.clay.rim_height();
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Ring on ring"));
  v.set_all(0.3);  // enough clay for this one, which is wider
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.outer += 0.02;
  v.status.feedback.wetness = 0.6;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "embers"));
  v.status.feedback.wetness = 0.1;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Dull blows"));
  v.status.feedback.wetness = 0.6;  // somebody wetted it
  v.status.feedback.hand[0].blow = 200.0;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Dull blows")) << "this one was dull";
  v.status.feedback.wetness = 0.1;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "slowly up and down"));
  v.set_all(0.31);
  v.frames(0.5);
  EXPECT_FALSE(says(v, "slowly up and down")) << "it is on the line";
}

// The lesson went on with "hold on" while the wheel stood, and for who had put the coil away.
TEST(LessonLine, SaysFirstWhatKeepsAStepFromBeingDone) {
  Builder v;
  v.throw_a_pot();
  v.frames(3);
  ASSERT_TRUE(says(v, "Ring on ring"));
  v.touch("throw.wheel");
  for (int n = 0; n < 20; ++n) v.touch("throw.slower");
  v.touch("throw.less");
  v.frames(3);
  EXPECT_TRUE(says(v, "has stopped")) << words_in(v.frame);
  v.touch("throw.wheel");
  v.touch("throw.faster");
  v.touch("throw.tools");
  v.touch("throw.tool.0");
  v.frames(3);
  EXPECT_TRUE(says(v, "then “Coil”")) << words_in(v.frame);
}

// It spoke of rings over a bare floor, and of blows where no wall was.
TEST(LessonLine, WhoHasNoRingYetOrTookThemAwayIsToldToLayThem) {
  Builder v;
  const auto floor = [&v](double share) {
    for (ShelfCard& card : v.shelf) card.wheel.floor = share * v.clay.rim_height();
  };
  floor(1.0);
  v.throw_a_pot();
  v.frames(v.build_lesson[0].after + 5);
  EXPECT_TRUE(says(v, "edge of the clay")) << "it is not hurried";
  floor(0.5);
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Ring on ring"));
  v.set_all(0.3);
  for (ShelfCard& card : v.shelf)
    for (ProfilePoint& p : card.target.points) p.outer += 0.02;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Dull blows"));
  v.set_all(Builder::kTall);
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Ring on ring")) << "rings were undone";
  floor(1.0);
  v.frames(0.5);
  EXPECT_TRUE(says(v, "edge of the clay")) << "all of them";
}

TEST(LessonLine, AsksForNoBlowsWhereTheSceneHasNoPaddle) {
  Builder v;
  for (ShelfCard& card : v.shelf) {
    card.wheel.beating.reset();
    card.wheel.tools.pop_back();
  }
  v.set_all(0.9);  // high enough
  v.throw_a_pot();
  v.frames(1);
  EXPECT_FALSE(says(v, "Dull blows")) << words_in(v.frame);
}

TEST(LessonLine, WhoKnowsHowToThrowIsStillTaughtToBuild) {
  Builder v;
  v.lesson = content::read_lesson("content/lessons/first_minute.toml", {"en", "ko"}).steps;
  std::optional<SceneForVisitor> built = v.shelf[0].wheel;
  v.shelf[0].wheel.coil.reset();
  v.throw_a_pot();
  v.frames(0.3);
  EXPECT_TRUE(says(v, "press a little"));
  v.touch("throw.skip");
  v.frames(0.3);
  EXPECT_FALSE(says(v, "press a little"));
  v.shelf[0].wheel = *built;
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Ring on ring")) << words_in(v.frame);
}

TEST(LessonLine, WithoutALessonTheHintStandsThere) {
  Visitor v;
  v.throw_a_pot();
  v.frames(0.5);
  EXPECT_FALSE(v.visit->control("throw.skip"));
  EXPECT_FALSE(says(v, "press a little"));
}

}  // namespace
}  // namespace onggi::screens::lesson_line_test
