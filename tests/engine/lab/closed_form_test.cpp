#include "engine/lab/closed_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/clay/clay.h"
#include "engine/lab/plain_wall.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"

// The reference in doubles, and the engine's own clay, against what pen and paper give.
namespace onggi::lab::closed_form_test {
namespace {

using portable::kPi;
constexpr double kTau = 0.00949;
constexpr double kBall = 0.008;

ClayDef grid(int rows, int sectors) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  return def;
}
// The element in front of a ball that comes along the first ray.
Vec3 before_first_ray(double d, int sectors, double height) {
  const double angle = kPi / sectors;
  return {d * portable::cos(angle), height, d * portable::sin(angle)};
}

TEST(ClosedForm, TheReferenceRelaxesUnderAHeldToolAsAMaxwellElementDoes) {
  PlainWall<double> wall(grid(401, 360), 0.09, 0.11);
  const int row = wall.rows() / 2;
  const double d = 0.055 + kBall - 0.001;
  const Vec3 at = before_first_ray(d, 360, wall.row_height(row));
  for (int n = 1; n <= 40; ++n) {
    wall.step({}, {.from = at, .to = at, .radius = kBall});
    const double press =
        wall.face(WallSide::outside)[static_cast<std::size_t>(row) * 360] - (d - kBall);
    EXPECT_NEAR(press, closed_form::held_press(0.001, kTau, 1e-3 * n), 1e-12);
  }
}

TEST(ClosedForm,
     AMovingToolsPressIsReachedAtTheTicksSquareByTheShippedRuleAndTheTickByTheExactOne) {
  const double speed = 0.05, seconds = 0.04;
  const auto off = [&](TimeRule rule, int steps) {
    PlainWall<double> wall(grid(401, 360), 0.09, 0.11);
    const int row = wall.rows() / 2;
    const double dt = seconds / steps;
    const auto at = [&](double t) {
      return before_first_ray(0.055 + kBall - speed * t, 360, wall.row_height(row));
    };
    for (int n = 0; n < steps; ++n)
      wall.step({.rule = rule},
                {.from = at(n * dt), .to = at((n + 1) * dt), .radius = kBall, .seconds = dt});
    const double press = wall.face(WallSide::outside)[static_cast<std::size_t>(row) * 360] -
                         (0.055 - speed * seconds);
    return std::fabs(press - closed_form::moving_press(0.0, speed, kTau, seconds));
  };
  EXPECT_NEAR(std::log2(off(TimeRule::shipped, 40) / off(TimeRule::shipped, 80)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(off(TimeRule::exact, 40) / off(TimeRule::exact, 80)), 1.0, 0.1);
  // A tenth a tick is another clay at every tick.
  EXPECT_GT(off(TimeRule::printed, 160), 0.25 * speed * kTau);
}

TEST(ClosedForm, APressedLensHasTheVolumeOfTheBallWithinTheCylinder) {
  // Held until it has all given way: rays from the axis then end on the ball.
  PlainWall<double> wall(grid(1600, 1440), 0.09, 0.11);
  const double d = 0.055 + kBall - 0.003;
  const Vec3 at{d, 0.1, 0.0};
  for (int n = 0; n < 200; ++n) wall.step({}, {.from = at, .to = at, .radius = kBall});
  double volume = 0.0;
  for (const double r : wall.face(WallSide::outside)) volume += 0.055 * 0.055 - r * r;
  volume *= 0.5 * wall.thickness() * 2.0 * kPi / wall.sectors();
  EXPECT_NEAR(volume / closed_form::lens_volume(kBall, 0.055, d), 1.0, 2e-4);
}

TEST(ClosedForm, ALensIsNothingBesideTheCylinderAndABallWithinIt) {
  EXPECT_EQ(closed_form::lens_volume(0.01, 0.05, 0.07), 0.0);
  EXPECT_NEAR(closed_form::lens_volume(0.01, 0.05, 0.02), 4.0 / 3.0 * kPi * 1e-6, 1e-16);
  // Half a ball, where the cylinder is as good as a plane.
  EXPECT_NEAR(closed_form::lens_volume(0.001, 1.0, 1.0) / (2.0 / 3.0 * kPi * 1e-9), 1.0, 1e-3);
  // The volume by random points.
  Random random(7);
  int within = 0;
  constexpr int kPoints = 400'000;
  for (int n = 0; n < kPoints; ++n) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    if (x * x + y * y + z * z < 1.0 && (x + 2.5) * (x + 2.5) + z * z < 4.0) ++within;
  }
  EXPECT_NEAR(8.0 * within / kPoints, closed_form::lens_volume(1.0, 2.0, 2.5), 0.01);
}

TEST(ClosedForm, AsATouchGetsLighterTheAreaForceBecomesHertzsGapAndKeepsItsPlaceOnAnyGrid) {
  const auto ratio = [](double depth) {
    // So fine that the light touch covers a hundred elements each way.
    PlainWall<double> wall(grid(16000, 8192), 0.0975, 0.1025);
    const Vec3 at{0.055 + kBall - depth, 0.1, 0.0};
    const Vec3 force = wall.step({.rule = TimeRule::exact, .quadrature = Quadrature::area},
                                 {.from = at, .to = at, .radius = kBall});
    return length(force) / closed_form::light_force(kBall, 0.055, depth, 5e6);
  };
  const double deeper = ratio(2e-4), lighter = ratio(1e-4);
  EXPECT_NEAR(lighter, 1.0, 0.02);
  EXPECT_NEAR((deeper - 1.0) / (lighter - 1.0), 2.0, 0.15);  // off by depth over radius
}

TEST(ClosedForm, TurnByTurnTheGrooveComesToTheBallsEnvelopeAndNeverPastIt) {
  PlainWall<double> wall(grid(200, 180), 0.085, 0.115);
  const double d = 0.055 + kBall - 0.002, turn = 31.4e-3;
  const Vec3 at{d, 0.1, 0.0};
  long tick = 0;
  const auto off_after = [&](long ticks) {
    for (; tick < ticks; ++tick) {
      const double n = static_cast<double>(tick);
      wall.step({}, {.from = at,
                     .to = at,
                     .radius = kBall,
                     .angle_from = n * turn,
                     .angle_to = (n + 1.0) * turn});
    }
    double most = 0.0;
    for (int j = 0; j < wall.rows(); ++j) {
      const double should = closed_form::groove(0.055, kBall, d, wall.row_height(j) - 0.1);
      for (std::size_t i = 0; i < 180; ++i) {
        const double off =
            wall.face(WallSide::outside)[static_cast<std::size_t>(j) * 180 + i] - should;
        EXPECT_GT(off, -1e-12);
        most = std::max(most, off);
      }
    }
    return most;
  };
  // The nearer the clay is to it, the shorter the ball touches: by the square of the turns.
  const double early = off_after(8000), late = off_after(32000);
  EXPECT_LT(early, 5e-5);
  EXPECT_NEAR(early / late, 16.0, 4.0);
}

TEST(ClosedForm, AConicWallWeighsWhatItsClayDoes) {
  const closed_form::ConicWall cone{0.05, 0.04, 0.08, 0.072, 0.2};
  ClayDef def = grid(800, 64);
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  for (int j = 0; j < clay.rows(); ++j) {
    const double share = clay.row_height(j) / 0.2;
    for (float& r : clay.outer_mut(j)) r = static_cast<float>(0.05 + share * 0.03);
    for (float& r : clay.inner_mut(j)) r = static_cast<float>(0.04 + share * 0.032);
  }
  EXPECT_NEAR(9.81 * 1950.0 * clay.volume() / closed_form::weight_above(cone, 0.0, 1950.0), 1.0,
              1e-5);
  EXPECT_EQ(closed_form::weight_above(cone, 0.2, 1950.0), 0.0);
  const double part = closed_form::weight_above(cone, 0.05, 1950.0);
  EXPECT_LT(part, closed_form::weight_above(cone, 0.0, 1950.0));
}

}  // namespace
}  // namespace onggi::lab::closed_form_test
