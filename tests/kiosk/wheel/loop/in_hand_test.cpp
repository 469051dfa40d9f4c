#include "kiosk/wheel/loop/in_hand.h"

#include <gtest/gtest.h>

#include "kiosk/wheel/loop/stepped_wheel.h"
#include "tests/kiosk/wheel/loop/pots.h"

namespace onggi::loop::in_hand_test {
namespace {

constexpr double kTick = 0.001;

TEST(Paddle, BeatsThreeTimesASecondAndEachBlowLiesItsTime) {
  Paddle paddle;
  int blows = 0, lay = 0;
  bool last = false;
  for (int n = 0; n < 3400; ++n) {
    const bool lies = paddle.step(true, kTick);
    blows += lies && !last ? 1 : 0;
    lay += lies ? 1 : 0;
    EXPECT_TRUE(!lies || paddle.back() == 0.0) << "on the wall";
    EXPECT_LE(paddle.back(), 1.0);
    last = lies;
  }
  EXPECT_EQ(blows, 10);
  EXPECT_NEAR(lay, 10 * 120, 12);
}

TEST(Paddle, FinishesABlowAndBeginsNoOtherWithoutAHand) {
  Paddle paddle;
  int n = 0;
  while (!paddle.step(true, kTick)) ++n;
  EXPECT_NEAR(n, 166, 2) << "ms from the hand to the blow";
  int lies = 1;
  for (int more = 0; more < 1000; ++more) lies += paddle.step(false, kTick) ? 1 : 0;
  EXPECT_NEAR(lies, 120, 2);
}

/// A force device whose tool lies `deep` (m) in the wall, or as far off it where that is negative.
class RestingHand final : public device::HandDevice {
 public:
  RestingHand(const SceneDef& def, const double& deep, int& blows)
      : def_(def), deep_(deep), blows_(blows) {}
  HandInput read(double) noexcept override { return press_at(def_, deep_); }
  void feel(const HandFeedback& felt) noexcept override {
    blows_ += felt.blow > 0.0 && !struck_ ? 1 : 0;
    struck_ = felt.blow > 0.0;
  }

 private:
  const SceneDef& def_;
  const double& deep_;
  int& blows_;
  bool struck_ = false;
};

TEST(Paddle, OfAForceDeviceBeatsWhileItRestsOnTheWallAndAtNoOtherTime) {
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.045;
  def.volume.emplace();
  def.beating.emplace();
  double deep = -0.010;
  int blows = 0;
  SteppedWheel host;
  host.start(pot(def));
  host.attach(std::make_unique<RestingHand>(def, deep, blows), 0);
  host.hold(InHand::paddle);
  host.advance(2000);
  EXPECT_EQ(blows, 0) << "a centimetre off the wall, as if about to touch it";
  deep = 0.001;
  host.advance(3400);
  EXPECT_NEAR(blows, 10, 1);
  const int struck = blows;
  deep = -0.010;
  host.advance(2000);
  EXPECT_EQ(blows, struck);
}

TEST(Paddle, StrikesAsHardAsTheScreensSayUntilItIsTakenUpAnew) {
  SceneDef def = small_scene();
  def.clay.inner_radius = 0.045;
  def.volume.emplace();
  def.beating.emplace();
  double deep = 0.001;
  int blows = 0;
  SteppedWheel host;
  host.start(pot(def));
  host.attach(std::make_unique<RestingHand>(def, deep, blows), 0);
  host.hold(InHand::paddle);
  host.advance(10);
  EXPECT_EQ(host.status().hands.hand[0].swing, 1.0);
  EXPECT_EQ(host.status().hands.hand[0].anvil, 1.0);
  host.swing({0.25, 0.75});
  host.advance(10);
  EXPECT_EQ(host.status().hands.hand[0].swing, 0.25);
  EXPECT_EQ(host.status().hands.hand[0].anvil, 0.75);
  host.hold(InHand::paddle);
  host.advance(10);
  EXPECT_EQ(host.status().hands.hand[0].swing, 1.0);
  host.hold(InHand::tool);
  host.swing({0.25, 0.75});
  host.advance(10);
  EXPECT_EQ(host.status().hands.hand[0].anvil, 0.0) << "no paddle";
}

}  // namespace
}  // namespace onggi::loop::in_hand_test
