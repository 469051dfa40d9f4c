#include "engine/effects/walls.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "tests/engine/effects/random_hands.h"

namespace onggi::effects::walls_test {
namespace {

using namespace effects_test;

SceneDef small() {
  SceneDef def;
  def.clay.rows = 80;
  def.clay.sectors = 64;
  def.clay.inner_radius = 0.045;
  def.clay.floor_thickness = 0.0;
  def.volume.emplace();
  def.walls.emplace();
  return def;
}

// One finger held to the middle of the wall that comes in, or goes out, by `way` in two seconds.
void press(Scene& scene, WallSide side, double way) {
  const double radius = scene.def().tool.radius;
  const bool outside = side == WallSide::outside;
  Hands hands;
  hands.wheel_speed = 18.0;
  hands.hand[0] = {{}, true, outside ? SideWish::outside : SideWish::inside};
  for (int n = 0; n < 3000; ++n) {
    const double gone = way * std::min(n / 2000.0, 1.0);
    hands.hand[0].position = {outside ? 0.055 + radius - gone : 0.045 - radius + gone, 0.1, 0};
    scene.step(hands, 0.001);
  }
}

struct Wall {
  double middle, thickness, area;
};
Wall wall_of(const Scene& scene, double height) {
  const Clay& clay = scene.clay();
  const int j = clay.first_row_above(height);
  const Profile p = clay.profile();
  const ProfilePoint& at = p.points[static_cast<std::size_t>(j) + 1];
  return {0.5 * (at.outer + at.inner), at.outer - at.inner, clay.measured_area(j)};
}

TEST(Walls, CollaringMakesTheWallThickerAndOpeningMakesItThinner) {
  Scene collared = made(small());
  const Wall first = wall_of(collared, 0.1);
  press(collared, WallSide::outside, 0.010);
  const Wall neck = wall_of(collared, 0.1);
  EXPECT_LT(neck.middle, first.middle - 0.008);
  EXPECT_GT(neck.thickness, 1.1 * first.thickness);
  EXPECT_NEAR(collared.clay().rim_height(), 0.2, 1e-4);  // it moved, it did not flow upwards
  Scene opened = made(small());
  press(opened, WallSide::inside, 0.010);
  const Wall belly = wall_of(opened, 0.1);
  EXPECT_GT(belly.middle, first.middle + 0.008);
  EXPECT_LT(belly.thickness, 0.9 * first.thickness);
}

TEST(Walls, AnUnsupportedPressKeepsTheAreaOfEveryRowItMoves) {
  Scene scene = made(small());
  const double area = wall_of(scene, 0.1).area;
  press(scene, WallSide::outside, 0.010);
  for (const double height : {0.093, 0.097, 0.1, 0.104})
    EXPECT_NEAR(wall_of(scene, height).area / area, 1.0, 1e-4) << height;
}

TEST(Walls, PressedBetweenTwoHandsTheWallThinsAndThePotRises) {
  Scene scene = made(small());
  Hands hands;
  hands.wheel_speed = 18.0;
  for (int n = 0; n < 3000; ++n) {
    const double off = 0.008 + 0.005 - 1e-6 * std::min(n, 2000);
    hands.hand[0] = {{0.050 + off, 0.1, 0}, true, SideWish::outside};
    hands.hand[1] = {{0.050 - off, 0.1, 0}, true, SideWish::inside};
    scene.step(hands, 0.001);
  }
  EXPECT_LT(wall_of(scene, 0.1).thickness, 0.0075);
  EXPECT_GT(scene.clay().rim_height(), 0.201);
}

TEST(Walls, WithoutThemAPressFromOneSideThins) {
  SceneDef def = small();
  def.walls.reset();
  Scene scene = made(def);
  press(scene, WallSide::outside, 0.004);
  EXPECT_LT(wall_of(scene, 0.1).thickness, 0.0075);
}

TEST(Walls, StandWithoutVolumeToo) {
  SceneDef def = small();
  def.volume.reset();
  Scene scene = made(def);
  const Wall first = wall_of(scene, 0.1);
  press(scene, WallSide::outside, 0.010);
  EXPECT_GT(wall_of(scene, 0.1).thickness, 1.1 * first.thickness);
}

RC_GTEST_PROP(WallsProperty, SupportFadesWithDistanceAlongTheWallAndNeverLeavesZeroToOne, ()) {
  const WallsDef def{*rc::gen::inRange(1, 200) * 1e-3};
  const double angle = *rc::gen::inRange(-314, 315) * 0.01;
  const double up = *rc::gen::inRange(-100, 101) * 1e-3;
  const Vec3 pressing{0.06, 0.1, 0.0};
  const auto holding = [&](double share) {
    const double turn = share * angle;
    return Vec3{0.04 * portable::cos(turn), 0.1 + share * up, 0.04 * portable::sin(turn)};
  };
  RC_ASSERT(wall_support(def, pressing, holding(0.0)) == 1.0);
  double last = 1.0;
  for (double share = 0.0; share <= 1.0; share += 0.05) {
    const double support = wall_support(def, pressing, holding(share));
    RC_ASSERT(support >= 0.0 && support <= last + 1e-9);
    last = support;
  }
}

// The greatest force on a finger that comes in by 3 mm in 0.3 s, N.
double pushed(double thickness, double strength, bool held) {
  SceneDef def = small();
  def.clay.rows = 200;
  def.clay.sectors = 180;
  def.clay.wall_min = 0.001;
  def.clay.inner_radius = def.clay.outer_radius - thickness;
  def.walls->bending_strength = strength;
  def.guard = {20.0, 1e5, 0.05};
  Scene scene = made(def);
  Hands hands;
  hands.wheel_speed = 6.0;
  double most = 0.0;
  for (int n = 0; n < 300; ++n) {
    const double out = def.clay.outer_radius + def.tool.radius - 1e-5 * n;
    const double in = def.clay.inner_radius - def.tool.radius + 1e-5 * n;  // it pushes as much
    hands.hand[0] = {{out, 0.1, 0.0}, true, SideWish::outside};
    if (held) hands.hand[1] = {{in, 0.1, 0.0}, true, SideWish::inside};
    most = std::max(most, length(scene.step(hands, 0.001).hand[0].force));
  }
  return most;
}

TEST(Walls, AThinWallIsFeltAsSofterThanAThickOneUnlessTheOtherHandHoldsIt) {
  const double thick = pushed(0.03, 9000.0, false);
  EXPECT_NEAR(pushed(0.03, 0.0, false) / thick, 1.0, 0.01) << "a thick one is as it was";
  double last = 1e9;
  for (const double thickness : {0.03, 0.01, 0.005, 0.003}) {
    const double force = pushed(thickness, 9000.0, false);
    const double bears = portable::kPi * 9000.0 * thickness * thickness;
    EXPECT_LT(force, 1.4 * bears) << "clay and wall give way one behind the other, and it thickens";
    EXPECT_LT(force, last + 1e-3) << thickness;
    last = force;
  }
  EXPECT_LT(last, 0.7 * thick);
  EXPECT_GT(pushed(0.003, 9000.0, true), 0.9 * pushed(0.003, 0.0, true)) << "held from inside";
}

// 10 mm and a tenth of one more for each row.
Clay tapered(int rows = 100, int sectors = 90) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  Clay clay = std::move(*Clay::create(def));
  for (int j = 0; j < clay.rows(); ++j)
    for (float& r : clay.inner_mut(j))
      r = 0.055f - (0.010f + 0.05f * static_cast<float>(clay.row_height(j)));
  return clay;
}

TEST(Walls, TheWallBehindAToolIsThatOfItsOwnHeightWhicheverWayItStands) {
  for (const auto& [rows, sectors] : {std::pair{100, 90}, std::pair{600, 512}, std::pair{16, 16}}) {
    const Clay clay = tapered(rows, sectors);
    const double far = std::max(0.008, 3.0 * clay.first_thickness());
    for (double height = 0.010 + far + 0.001; height < 0.2 - far - 0.001; height += 0.0007)
      for (const double distance : {0.0, 0.01, 0.055})
        for (const double angle : {0.0, 1e-9, 1.0, 3.1415, -3.1415, -1.0, -1e-9}) {
          const WallBehind wall = wall_behind(
              clay, nullptr, {distance * std::cos(angle), height, distance * std::sin(angle)});
          ASSERT_NEAR(wall.thickness, 0.010 + 0.05 * height, rows > 16 ? 5e-6 : 1e-4)
              << height << " at " << angle << ", " << distance << " m from the axis";
          ASSERT_NEAR(wall.thicker.y, 0.05, rows > 16 ? 0.005 : 0.02);
          ASSERT_NEAR(wall.thicker.x, 0.0, 1e-6);
        }
    // Above the rim and low at the foot it is that of the clay which is there.
    EXPECT_NEAR(wall_behind(clay, nullptr, {0.055, 0.5, 0}).thickness, 0.02, far * 0.05);
    EXPECT_EQ(wall_behind(clay, nullptr, {0.055, 0.5, 0}).thicker.y, 0.0);
    EXPECT_NEAR(wall_behind(clay, nullptr, {0.055, clay.floor_top() + 1e-4, 0}).thickness, 0.0105,
                far * 0.05);
  }
}

// Rows and elements that differ by 5 mm, and a band that is wet.
struct Rough {
  Clay clay = tapered();
  Moisture moisture;

  Rough() : moisture(wet_bands(), clay.rows()) {
    Random random(5);
    for (int j = clay.floor_rows(); j < clay.rows(); ++j)
      for (float& r : clay.inner_mut(j)) r -= static_cast<float>(random.uniform(0.0, 0.005));
    const std::array heights{0.1};
    for (int n = 0; n < 100; ++n) moisture.soak_or_dry(wet_bands(), clay, 0.005, true, heights);
  }
  static MoistureDef wet_bands() { return {.sponge_height = 0.03}; }
};

TEST(Walls, TheWallBehindAToolHasNoStepsAndItsSlopesHaveNoneWhateverItsShape) {
  const Rough pot;
  Random random(6);
  constexpr double kWay = 1e-6;
  for (int round = 0; round < 300; ++round) {
    const double angle = random.uniform(-4.0, 4.0), way = random.uniform(-4.0, 4.0);
    Vec3 at{0.055 * std::cos(angle), random.uniform(0.0105, 0.21), 0.055 * std::sin(angle)};
    const Vec3 on = kWay * Vec3{-std::sin(angle) * std::cos(way), std::sin(way),
                                std::cos(angle) * std::cos(way)};
    WallBehind last = wall_behind(pot.clay, &pot.moisture, at);
    for (int n = 0; n < 1000; ++n) {
      at += on;
      const WallBehind now = wall_behind(pot.clay, &pot.moisture, at);
      // What it says of its slopes is what it does.
      ASSERT_NEAR(now.thickness - last.thickness, 0.5 * dot(now.thicker + last.thicker, on), 2e-9);
      ASSERT_NEAR(now.wetness - last.wetness, 0.5 * dot(now.wetter + last.wetter, on), 1e-6);
      ASSERT_LT(length(now.thicker - last.thicker), 5e-4) << "at " << at.y;
      ASSERT_LT(length(now.wetter - last.wetter), 0.1) << "at " << at.y;
      last = now;
    }
  }
}

TEST(Walls, BearAPushByTheSquareOfTheirThicknessAndNeverMore) {
  WallsDef def;
  def.bending_strength = 8000.0;
  const double bears = wall_bears(def, 0.004, 1.0);
  EXPECT_NEAR(bears, 0.4021, 1e-4);
  EXPECT_NEAR(wall_bears(def, 0.008, 0.5), 2.0 * bears, 1e-12);
  double last = 0.0, steepest = 0.0;
  for (double normal = 0.01; normal < 50.0; normal *= 1.1) {
    const double felt = wall_push(normal, bears, 0.0);
    EXPECT_LT(felt, bears);
    if (last > 0.0) steepest = std::max(steepest, (felt - last) / (normal / 11.0));
    EXPECT_GT(felt, last);
    EXPECT_EQ(wall_push(normal, bears, normal), normal) << "held";
    last = felt;
  }
  EXPECT_LT(steepest, 1.0 + 1e-3) << "no stiffer than the clay, so what a device bears is enough";
}

TEST(Walls, AreFeltAsMoreByNoMoreThanTheOtherHandHoldsMore) {
  for (const double normal : {0.1, 1.0, 5.0})
    for (const double bears : {0.0, 0.1, 1.0}) {
      double last = wall_push(normal, bears, 0.0);
      for (double held = 0.0; held < normal; held += 0.01 * normal) {
        const double felt = wall_push(normal, bears, held);
        EXPECT_GE(felt, held);
        EXPECT_LE(felt, held + bears);
        EXPECT_GE(felt, last - 1e-12);
        EXPECT_LE(felt, last + 0.01 * normal + 1e-12);
        last = felt;
      }
    }
}

TEST(Walls, TheFootHoldsThemByNoStep) {
  const Clay clay = tapered();
  const double top = clay.floor_top();
  EXPECT_EQ(clear_of_foot(clay, top - 0.01).share, 0.0);
  EXPECT_EQ(clear_of_foot(clay, top).share, 0.0);
  EXPECT_EQ(clear_of_foot(clay, top + 0.008).share, 1.0);
  for (double up = -0.001; up < 0.01; up += 1e-6) {
    const ClearOfFoot here = clear_of_foot(clay, top + up);
    const ClearOfFoot next = clear_of_foot(clay, top + up + 1e-6);
    ASSERT_NEAR(next.share - here.share, 0.5e-6 * (here.rise + next.rise), 1e-9);
    ASSERT_NEAR(next.rise, here.rise, 0.2);
  }
}

// What a wall that bends stores less, added up over the depth. A ball's push on an even face is the
// sum of the elements' less what they lose aside.
double stored_less(double alone, double clear, double bears, double depth, double radius) {
  const auto normal = [radius](double l) {
    return radius > 0.0 ? l * l * (radius - l / 3.0) : std::pow(l, 1.5);
  };
  const auto push = [radius](double l) {
    const double h = radius - l;
    return radius > 0.0 ? 2.0 / radius *
                              (radius * radius * radius * radius / 4.0 -
                               h * radius * radius * radius / 3.0 + h * h * h * h / 12.0)
                        : std::pow(l, 1.5);
  };
  double sum = 0.0;
  constexpr int kParts = 20000;
  for (int n = 0; n < kParts; ++n) {
    const double l = (n + 0.5) / kParts * depth;
    const double all = clear * alone * normal(l) / normal(depth);
    sum += depth / kParts * push(l) / normal(l) * (all - wall_push(all, bears, 0.0));
  }
  return sum;
}

TEST(Walls, StoreLessWhereTheyBendBySlopesThatAreThoseOfTheSum) {
  for (const double radius : {0.008, 0.018, 0.0})
    for (const double depth : {0.0005, 0.003, 0.007})
      for (const double alone : {0.1, 1.0, 8.0})
        for (const double bears : {0.2, 1.0, 30.0})
          for (const double clear : {0.1, 0.5, 0.9}) {
            const BendSlopes slopes = bend_slopes(alone, clear, bears, depth, radius);
            const auto less = [&](double c, double p) {
              return stored_less(alone, c, p, depth, radius);
            };
            const double by_clear = (less(clear + 1e-3, bears) - less(clear - 1e-3, bears)) / 2e-3;
            const double by_bears =
                (less(clear, 1.001 * bears) - less(clear, 0.999 * bears)) / (0.002 * bears);
            const double whole = alone * depth;
            ASSERT_NEAR(slopes.by_clear, by_clear, 0.002 * whole) << bears << ' ' << clear;
            ASSERT_NEAR(slopes.by_bears, by_bears, 0.02 * depth) << bears << ' ' << clear;
          }
  EXPECT_EQ(bend_slopes(1.0, 0.0, 1.0, 0.003, 0.008).by_clear, 0.0) << "all foot";
}

TEST(Walls, WhateverHandsDoNoFaceCrossesTheOther) {
  SceneDef def = small();
  def.clay.wall_min = 0.002;
  expect_clay_kept(def, 21, 30000);
}

}  // namespace
}  // namespace onggi::effects::walls_test
