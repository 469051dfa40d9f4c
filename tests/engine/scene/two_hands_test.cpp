#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/scene/scene.h"

namespace onggi::two_hands_test {
namespace {

constexpr double kRadius = 0.008;
constexpr double kMiddle = 0.050;  // of the wall

SceneDef wall(double thickness = 0.010) {
  SceneDef def;
  def.clay.rows = 200;
  def.clay.sectors = 180;
  def.clay.outer_radius = kMiddle + 0.5 * thickness;
  def.clay.inner_radius = kMiddle - 0.5 * thickness;
  def.guard.max_force = 22.2;
  def.guard.max_slew = 1e5;
  def.guard.engage_time = 0.05;
  return def;
}

// One hand outside, one inside, `gap` of clay between them, at one height.
Hands pinch(double gap, bool outside_first, double height = 0.1, double speed = 18.0) {
  Hands hands;
  const HandInput out{{kMiddle + 0.5 * gap + kRadius, height, 0}, true, SideWish::outside};
  const HandInput in{{kMiddle - 0.5 * gap - kRadius, height, 0}, true, SideWish::inside};
  hands.hand = outside_first ? std::array{out, in} : std::array{in, out};
  hands.wheel_speed = speed;
  return hands;
}

struct Squeezed {
  Scene scene;
  std::vector<double> out, in;  // radial forces on the two hands, a tick each
};

// Closes from `gap_from` to `gap_to` in two seconds, and holds for two.
Squeezed squeeze(const SceneDef& def, double gap_from, double gap_to, bool outside_first = true) {
  Squeezed s{std::move(*Scene::create(def)), {}, {}};
  for (int n = 0; n < 4000; ++n) {
    const double share = std::min(n / 2000.0, 1.0);
    const Hands hands = pinch(gap_from + share * (gap_to - gap_from), outside_first);
    const Feedback felt = s.scene.step(hands, 0.001);
    s.out.push_back(felt.hand[outside_first ? 0 : 1].force.x);
    s.in.push_back(felt.hand[outside_first ? 1 : 0].force.x);
    EXPECT_EQ(felt.hand[outside_first ? 0 : 1].place, Place::outside);
    EXPECT_EQ(felt.hand[outside_first ? 1 : 0].place, Place::inside);
  }
  return s;
}

double thinnest(const Clay& clay) {
  float least = 1.0f;
  for (int j = clay.floor_rows(); j < clay.rows(); ++j)
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i)
      least = std::min(least, clay.outer(j)[i] - clay.inner(j)[i]);
  return double{least};
}

TEST(TwoHands, ThinTheWallToWhatIsBetweenThemAndLeaveItsMiddle) {
  const Squeezed s = squeeze(wall(), 0.011, 0.006);
  const Profile p = s.scene.clay().profile();
  EXPECT_NEAR(p.outer_at(0.1), kMiddle + 0.003, 0.0002);
  EXPECT_NEAR(p.inner_at(0.1), kMiddle - 0.003, 0.0002);
  EXPECT_EQ(p.outer_at(0.15), double{0.055f});
}

TEST(TwoHands, NeverThinTheWallBelowItsLeastHoweverHardTheySqueeze) {
  const Squeezed s = squeeze(wall(), 0.011, 0.001);
  const Profile p = s.scene.clay().profile();
  EXPECT_GE(thinnest(s.scene.clay()), 0.004 - 3e-8);
  EXPECT_NEAR(p.outer_at(0.1) - p.inner_at(0.1), 0.004, 1e-5);
  EXPECT_NEAR(p.outer_at(0.1), kMiddle + 0.002, 0.0007);  // it stays between them
  // Now it cannot give way, and each feels the other through it: to and fro alike.
  double out = 0.0;
  double in = 0.0;
  for (std::size_t n = 3000; n < 4000; ++n) {
    out += s.out[n] / 1000;
    in += s.in[n] / 1000;
  }
  EXPECT_GT(out, 0.2);
  EXPECT_LT(in, -0.2);
  EXPECT_NEAR(out / -in, 1.0, 0.01);  // across the faces they are not quite mirrored
}

// A wall has no mass: what one hand gives to it the other gets, though the outer face is longer.
TEST(TwoHands, ThatPinchAWallFeelEqualAndOppositeForces) {
  for (const double thickness : {0.0041, 0.006, 0.010}) {
    SceneDef def = wall(thickness);
    def.clay.sectors = 720;
    Scene s = std::move(*Scene::create(def));
    double out = 0.0, in = 0.0;
    for (int n = 0; n < 200; ++n) {
      const Feedback felt = s.step(pinch(thickness - 0.004, true), 0.001);
      out += felt.hand[0].touch.push.x;
      in += felt.hand[1].touch.push.x;
    }
    EXPECT_GT(out, 1.0);
    EXPECT_NEAR(out / -in, 1.0, 0.02) << thickness;  // each face alone: 1.08 to 1.2
  }
}

// And one that grazes it is not lent the other's force.
TEST(TwoHands, OneThatGrazesAWallThatTheOtherPressesFeelsItsOwnPush) {
  for (const double deep : {1e-4, 3e-4}) {
    double felt[2];
    for (const bool both : {false, true}) {
      Scene s = std::move(*Scene::create(wall()));
      Hands hands = pinch(0.010, true);
      hands.hand[0].position.x -= 0.002;
      hands.hand[0].active = both;
      hands.hand[1].position.x += deep;
      felt[both] = length(s.step(hands, 1e-6).hand[1].touch.push);
    }
    EXPECT_GT(felt[0], 0.0);
    EXPECT_NEAR(felt[1] / felt[0], 1.0, 1e-4);
  }
}

TEST(TwoHands, DoNotChatterOnAWallThatCannotGiveWay) {
  const Squeezed s = squeeze(wall(), 0.011, 0.001);
  double most = 0.0;
  double jump = 0.0;
  for (std::size_t n = 3001; n < 4000; ++n) {
    most = std::max(most, s.out[n]);
    jump = std::max(jump, std::fabs(s.out[n] - s.out[n - 1]));
  }
  EXPECT_LT(jump, 0.05 * most);
}

TEST(TwoHands, ItDoesNotMatterWhichIsCalledTheFirst) {
  for (const double gap : {0.006, 0.001}) {
    const Squeezed a = squeeze(wall(), 0.011, gap, true);
    const Squeezed b = squeeze(wall(), 0.011, gap, false);
    EXPECT_EQ(a.scene.clay().hash(), b.scene.clay().hash());
    EXPECT_EQ(a.out, b.out);
    EXPECT_EQ(a.in, b.in);
  }
}

TEST(TwoHands, AreReportedOnTheRimAndOnTheFloor) {
  SceneDef def = wall();
  Scene s = std::move(*Scene::create(def));
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0] = {{kMiddle, 0.22, 0}, true, SideWish::outside};
  hands.hand[1] = {{0.0, 0.05, 0}, true, SideWish::inside};
  Feedback felt;
  double up[2] = {0, 0};
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0].position.y = std::max(0.22 - 1e-5 * n, 0.2 + kRadius - 0.003);
    hands.hand[1].position.y = std::max(0.05 - 2e-5 * n, 0.010 + kRadius - 0.008);
    felt = s.step(hands, 0.001);
    for (int h : {0, 1}) up[h] = std::max(up[h], felt.hand[static_cast<std::size_t>(h)].force.y);
  }
  EXPECT_EQ(felt.hand[0].place, Place::rim);
  EXPECT_EQ(felt.hand[1].place, Place::floor);
  EXPECT_TRUE(felt.hand[0].contact);
  EXPECT_TRUE(felt.hand[1].contact);
  EXPECT_GT(up[0], 0.1);
  EXPECT_GT(up[1], 0.3);
  EXPECT_LT(s.clay().rim_height(), 0.199);
  EXPECT_EQ(s.clay().floor_top(), 0.004);
}

TEST(WheelHead, StopsAToolEvenWhereThePotHasNoFloor) {
  SceneDef def = wall();
  def.clay.floor_thickness = 0.0;
  Scene s = std::move(*Scene::create(def));
  Hands hands;
  hands.hand[0] = {{0.0, 0.02, 0}, true, SideWish::inside};
  Feedback felt;
  for (int n = 0; n < 1000; ++n) {
    hands.hand[0].position.y = std::max(0.02 - 2e-5 * n, kRadius - 0.002);
    felt = s.step(hands, 0.001);
  }
  EXPECT_NEAR(felt.hand[0].force.y, 5e6 * 3.14159265 * 4e-6 * (kRadius - 0.002 / 3), 1e-3);
}

}  // namespace
}  // namespace onggi::two_hands_test
