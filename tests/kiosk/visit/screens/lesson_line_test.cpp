#include "kiosk/visit/screens/lesson_line.h"

#include <gtest/gtest.h>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {
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
};

TEST(LessonLine, EachStepIsOverWhenTheVisitorHasDoneItAndTheNextComes) {
  Learner v;
  EXPECT_TRUE(says(v, "press a little"));
  v.touch_clay(0.5);
  EXPECT_TRUE(says(v, "press a little")) << "a brush with the hand is no touch";
  v.touch_clay(0.8);
  EXPECT_TRUE(says(v, "from the inside"));
  v.touch_clay(1.2, WallSide::inside);
  EXPECT_TRUE(says(v, "Pull it"));
  v.meet();
  for (double h = 0.03; h < 0.12; h += 0.005) {
    v.status.hand[0].at = {0.06, h, 0};
    v.frames(0.1);
  }
  v.status.feedback.hand[0] = {};
  v.frames(0.5);
  EXPECT_TRUE(says(v, "Shape it"));
}

TEST(LessonLine, WhatWasDoneBeforeItsTurnIsNotAskedFor) {
  Learner v;
  v.touch_clay(1.5, WallSide::inside);  // touched, and inside
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

TEST(LessonLine, AStepThatWasShownDoesNotBeginAnewWithAnotherVessel) {
  Learner v;
  v.touch_clay(1.2);
  ASSERT_TRUE(says(v, "from the inside"));
  v.touch("back");
  v.touch("leaving.go");
  v.touch("choose.card.1");
  v.touch("choose.throw");
  v.frames(0.5);
  EXPECT_TRUE(says(v, "from the inside"));
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

TEST(LessonLine, WithoutALessonTheHintStandsThere) {
  Visitor v;
  v.throw_a_pot();
  v.frames(0.5);
  EXPECT_FALSE(v.visit->control("throw.skip"));
  EXPECT_FALSE(says(v, "press a little"));
}

}  // namespace
}  // namespace onggi::screens
