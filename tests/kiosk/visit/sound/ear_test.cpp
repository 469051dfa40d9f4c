#include "kiosk/visit/sound/ear.h"

#include <gtest/gtest.h>

namespace onggi::sound::ear_test {
namespace {

loop::LoopStatus throwing(std::string_view tool) {
  loop::LoopStatus status;
  status.feedback.wheel_speed = 18.0;
  status.feedback.wetness = 0.5;
  status.hand[1].name = tool;
  HandFeedback& felt = status.feedback.hand[1];
  felt.contact = true;
  felt.touch.push = {3, 0, 4};
  felt.touch.clay = {0, 0, 0.9};
  return status;
}

TEST(Ear, HearsTheWheelAndTheHandThatTouches) {
  const Heard heard = hear(throwing("sphere"));
  EXPECT_EQ(heard.wheel, 18.0);
  EXPECT_EQ(heard.wet, 0.5);
  EXPECT_EQ(heard.rub[0].push, 0.0);
  EXPECT_EQ(heard.rub[1].push, 5.0);
  EXPECT_EQ(heard.rub[1].slip, 0.9);
}

TEST(Ear, TellsToolsByWhatTheyAreMadeOf) {
  const auto kind = [](std::string_view tool) { return hear(throwing(tool)).rub[1].kind; };
  for (const char* hand : {"sphere", "fingertip", "palm"}) EXPECT_EQ(kind(hand), Rub::Kind::hand);
  for (const char* rib : {"flat_rib", "curved_rib", "loop_trimmer", "needle"})
    EXPECT_EQ(kind(rib), Rub::Kind::rib);
  EXPECT_EQ(kind("sponge"), Rub::Kind::sponge);
  EXPECT_EQ(kind("wire"), Rub::Kind::wire);
}

TEST(Ear, HearsThePaddleThatLiesOnTheWall) {
  loop::LoopStatus status = throwing("sphere");
  EXPECT_EQ(hear(status).knock[1].force, 0.0);
  status.feedback.hand[1].blow = 60.0;
  EXPECT_EQ(hear(status).knock[1].force, 60.0);
  status.shown = true;
  EXPECT_EQ(hear(status).knock[1].force, 0.0);
}

TEST(Ear, HearsNothingOfAPotThatIsOnlyShown) {
  loop::LoopStatus status = throwing("sphere");
  status.shown = true;
  const Heard heard = hear(status);
  EXPECT_EQ(heard.wheel, 0.0);
  EXPECT_EQ(heard.rub[1].push, 0.0);
}

TEST(Ear, HearsNoHandThatIsOnlyNear) {
  loop::LoopStatus status = throwing("sphere");
  status.feedback.hand[1].contact = false;
  EXPECT_EQ(hear(status).rub[1].push, 0.0);
}

}  // namespace
}  // namespace onggi::sound::ear_test
