#include "kiosk/visit/screens/pot_picture.h"

#include <gtest/gtest.h>

#include <tuple>

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens::pot_picture_test {
namespace {

TEST(PotPicture, APotThatWasCutFreeStandsWhileTheWheelTurns) {
  Visitor v;
  v.throw_a_pot();
  v.clay.angle = 1.25;
  v.status.feedback.wheel_angle = 2.5;
  v.show();
  EXPECT_EQ(v.frame.pot->clay_angle, 1.25);
  EXPECT_EQ(v.frame.pot->wheel_angle, 2.5);
}

TEST(PotPicture, HandsAreSeenWithWhatTheyHoldWhileThereIsAPotToWorkOn) {
  Visitor v;
  v.throw_a_pot();
  v.status.hand[1].present = true;
  v.status.hand[1].body = BodyKind::box;
  v.status.hand[1].length = 0.09;
  v.show();
  EXPECT_FALSE(v.frame.pot->hands[0].present);
  EXPECT_TRUE(v.frame.pot->hands[1].present);
  EXPECT_EQ(v.frame.pot->hands[1].body, BodyKind::box);
  EXPECT_EQ(v.frame.pot->hands[1].length, 0.09);
}

TEST(PotPicture, APotInTheKilnRestsAndTurnsBeforeTheEyeFromTheSpeedItHad) {
  Visitor v(9, nullptr, true);
  v.throw_a_pot();
  v.frames(1);
  v.status.feedback.wheel_speed = 15;
  v.touch("throw.done");
  ASSERT_EQ(v.visit->screen(), ScreenId::result);
  EXPECT_TRUE(v.wheel_commands.pauses.back());
  EXPECT_EQ(v.wheel_commands.settled, 1);
  v.touch("result.keep");
  const auto turned_in = [&](double seconds) {
    double sum = 0, last = v.frame.pot->clay_angle;
    for (int n = 0; n < seconds * 30; ++n) {
      v.show();
      sum += std::remainder(v.frame.pot->clay_angle - last, 6.283185307179586);
      last = v.frame.pot->clay_angle;
      EXPECT_EQ(v.frame.pot->clay_angle, v.frame.pot->wheel_angle);
    }
    return sum;
  };
  EXPECT_GT(turned_in(0.2), 1.8);
  turned_in(1);
  EXPECT_NEAR(turned_in(1), 1.2, 0.1);
  v.touch("back");
  v.touch("back");
  EXPECT_FALSE(v.wheel_commands.pauses.back());
}

// That no control stands in the shadow is asked of every screen by check_layout().
TEST(PotPicture, IsTheSameInAMirrorWhereWordsStandAtTheRightItsLightToo) {
  for (const auto& [width, height] : {std::pair(1280, 720), {1920, 1080}, {1024, 600}}) {
    Visitor right(9, nullptr, true), left(9, nullptr, true);
    left.exhibit.screen.left_handed = true;
    for (Visitor* v : {&right, &left}) std::tie(v->width, v->height) = std::pair(width, height);
    const auto same = [&, wide = width](const char* screen) {
      SCOPED_TRACE(screen + std::to_string(wide));
      for (Visitor* v : {&right, &left}) v->frames(1);
      const view::PotView &a = *right.frame.pot, &b = *left.frame.pot;
      EXPECT_EQ(a.window, view::kWindowLeft);
      EXPECT_EQ(b.window, view::kWindowRight);
      EXPECT_NEAR(a.camera.distance, b.camera.distance, 1e-6) << "it is as large";
      EXPECT_NEAR(a.camera.centre_x, static_cast<float>(wide) - b.camera.centre_x, 0.5f);
    };
    same("attract");
    for (Visitor* v : {&right, &left}) v->throw_a_pot();
    same("wheel");
    for (Visitor* v : {&right, &left}) v->touch("throw.done");
    right.frames(1), left.frames(1);
    EXPECT_EQ(right.frame.pot->window, view::kWindowLeft);
    EXPECT_EQ(left.frame.pot->window, view::kWindowRight);
    for (Visitor* v : {&right, &left}) v->touch("result.keep");
    same("kiln");
  }
}

TEST(PotPicture, UprightLightComesFromTheLeftWhicheverHand) {
  for (const bool left_handed : {false, true}) {
    Visitor v;
    v.exhibit.screen.left_handed = left_handed;
    std::tie(v.width, v.height) = std::pair(1080, 1920);
    v.show();
    ASSERT_TRUE(v.frame.pot);
    EXPECT_EQ(v.frame.pot->window, view::kWindowLeft);
  }
}

TEST(PotPicture, NothingTurnsWhereMotionIsReduced) {
  Visitor v;
  v.exhibit.screen.reduced_motion = true;
  v.throw_a_pot();
  v.status.feedback.wheel_speed = 15;
  v.touch("throw.done");
  v.frames(1);
  EXPECT_EQ(v.frame.pot->clay_angle, v.clay.angle);
}

TEST(PotPicture, APotIsNotJudgedBeforeEveryRowOfItHasArrived) {
  Visitor v;
  v.throw_a_pot();
  v.wheel_commands.answers = false;
  v.touch("throw.done");
  v.frames(0.2);
  EXPECT_EQ(v.visit->screen(), ScreenId::throwing);
  EXPECT_GT(v.wheel_commands.settled, 1);
  for (int j = 0; j < v.clay.rows(); ++j)
    v.clay.shape(j, std::vector<float>(16, 0.09f), std::vector<float>(16, 0.05f));
  v.wheel_commands.answers = true;
  v.show();
  EXPECT_EQ(v.visit->screen(), ScreenId::result);
  EXPECT_NEAR(v.visit->score().measures.made.belly / v.visit->score().measures.scale, 0.18, 1e-4);
}

}  // namespace
}  // namespace onggi::screens::pot_picture_test
