#include "engine/contact/rim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/clay/lip.h"
#include "engine/contact/paper_model.h"
#include "engine/contact/tool_contact.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "tests/support/sphere.h"

namespace onggi::rim_test {
namespace {

constexpr double kTau = 0.00949;
constexpr Yielding kClay{kTau, 5e6};
constexpr double kRadius = 0.008;
constexpr double kRim = 0.2;

// A thrown cylinder, 6 mm in the wall.
ClayDef cylinder(int rows = 400, int sectors = 360) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.inner_radius = 0.049;
  return def;
}
Clay lump(const ClayDef& def = cylinder()) { return std::move(*Clay::create(def)); }

BallStep still(Vec3 at, double seconds = 0.001) { return {at, at, kRadius, seconds}; }

struct Turning {
  Clay& clay;
  ToolContact contact{};
  double angle = 0.0;
  double most_up = 0.0;
  Press last{};

  void tick(Vec3 from, Vec3 to, double turn) {
    const ToolSweep sweep = sweep_sphere(from, to, kRadius, angle, turn);
    const int steps = steps_for(sweep, kClay.relaxation_time, contact.pressed());
    contact.begin_tick();
    for (int n = 0; n < steps; ++n) contact.step(clay, sweep, n, steps, kClay);
    angle += turn;
    last = contact.reaction();
    most_up = std::max(most_up, last.force.y);
  }
  // From one place to another at an even pace, on a wheel at 172 rpm.
  void move(Vec3 from, Vec3 to, int ticks) {
    for (int n = 0; n < ticks; ++n)
      tick(from + (1.0 * n / ticks) * (to - from), from + (1.0 * (n + 1) / ticks) * (to - from),
           0.018);
  }
};

void expect_whole(const Clay& clay) {
  double edge = 0.0;
  const float rounding = 3e-8f;
  for (int j = 0; j < clay.rows(); ++j) {
    ASSERT_GT(clay.row_thickness(j), 0.2 * clay.def().height / clay.rows());
    ASSERT_NEAR(clay.row_height(j), edge + 0.5 * clay.row_thickness(j), 1e-12);
    edge += clay.row_thickness(j);
    ASSERT_EQ(clay.row_height(j) < clay.floor_top(), j < clay.floor_rows()) << j;
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      const float in = clay.inner(j)[i];
      ASSERT_GE(clay.outer(j)[i], in + static_cast<float>(clay.def().wall_min) - rounding);
      ASSERT_LE(clay.outer(j)[i], static_cast<float>(clay.def().radius_max) + rounding);
      if (j < clay.floor_rows())
        ASSERT_EQ(in, 0.0f);
      else
        ASSERT_GE(in, static_cast<float>(clay.def().radius_min) - rounding);
    }
  }
}

TEST(Rim, PressedDownLowersThePotAndIsFeltUpward) {
  Clay clay = lump();
  Turning hand{clay};
  hand.move({0.052, kRim + kRadius + 0.001, 0}, {0.052, kRim + kRadius - 0.010, 0}, 3000);
  EXPECT_EQ(hand.contact.place(), Place::rim);
  EXPECT_LT(clay.rim_height(), kRim - 0.006);
  EXPECT_GT(hand.most_up, 0.3);
  EXPECT_GT(hand.last.force.y, 3.0 * std::hypot(hand.last.force.x, hand.last.force.z));
  // The belly knows nothing of it.
  for (int j = 0; j < 200; ++j) {
    EXPECT_EQ(clay.row_height(j), lump().row_height(j));
    EXPECT_EQ(clay.outer(j)[0], 0.055f);
  }
  expect_whole(clay);
}

TEST(Rim, FlaringWidensTheMouthAndLeavesTheBelly) {
  Clay clay = lump();
  Turning hand{clay};
  // Half on the lip, half over the mouth, drawn outwards.
  hand.move({0.046, kRim + 0.006, 0}, {0.046, kRim + 0.003, 0}, 500);
  hand.move({0.046, kRim + 0.003, 0}, {0.056, kRim + 0.003, 0}, 3000);
  const Profile p = clay.profile();
  EXPECT_GT(p.outer_at(0.2), 0.0565);
  EXPECT_GT(p.inner_at(0.2), 0.0505);
  for (double h = 0.16; h < 0.198; h += 0.002)  // the rows below follow less and less
    EXPECT_LE(p.outer_at(h), p.outer_at(h + 0.002) + 1e-5) << h;
  EXPECT_NEAR(p.outer_at(0.15), 0.055, 1e-6);
  EXPECT_NEAR(p.outer_at(0.1), 0.055, 1e-6);
  expect_whole(clay);
}

TEST(Rim, PushesUpWithTheVolumeThatTheToolCovers) {
  // On a broad top: the sum over the cap of depth times the upright share of the ball's normal,
  // (2 pi / r) (r^4/4 - h r^3/3 + h^4/12) with h = r - depth.
  ClayDef def;
  def.outer_radius = 0.08;
  def.inner_radius = 0.02;
  const double l = 0.001;
  const double h = kRadius - l;
  const double closed =
      2 * portable::kPi / kRadius *
      (std::pow(kRadius, 4) / 4 - h * std::pow(kRadius, 3) / 3 + std::pow(h, 4) / 12);
  Clay clay = lump(def);
  const Press press = press_rim(clay, still({0.05, kRim + h, 0}, 1e-6), kClay);
  EXPECT_NEAR(press.force.y / (5e6 * closed), 1.0, 0.01);
  EXPECT_NEAR(press.force.x / press.force.y, 0.0, 0.02);
  EXPECT_NEAR(press.force.z / press.force.y, 0.0, 0.01);
  EXPECT_NEAR(press.depth, l, 0.05 * l);
}

// The ring's press, summed by brute force over a fine net of the plane. The pot stands round.
double brute_up(double inner, double outer, Vec3 at, double rim, bool felt = false) {
  const double net = 4e-5;
  double sum = 0.0;
  for (double x = at.x - kRadius; x < at.x + kRadius; x += net)
    for (double z = at.z - kRadius; z < at.z + kRadius; z += net) {
      const double rho = std::hypot(x, z);
      const double square = kRadius * kRadius - std::pow(x - at.x, 2) - std::pow(z - at.z, 2);
      if (rho < inner || rho > outer || square <= 0.0) continue;
      const double rise = std::sqrt(square);
      const double l = rim - lip_drop(inner, outer, rho) - at.y + rise;
      if (l <= 0.0) continue;
      const double press = std::min(l, 2 * rise);
      const double share = press / kRadius;
      sum += (felt ? kRadius * (std::expm1(share) - share * share) : press * rise / kRadius) * net *
             net;
    }
  return sum;
}

TEST(Rim, AgreesWithTheSameLawSummedByBruteForce) {
  Random random(3);
  for (int round = 0; round < 12; ++round) {
    ClayDef def = cylinder(100, 720);
    def.outer_radius = random.uniform(0.02, 0.07);
    def.inner_radius = def.outer_radius - random.uniform(0.0045, 0.015);
    Clay clay = lump(def);
    const double d = random.uniform(def.inner_radius - 0.003, def.outer_radius + 0.003);
    const Vec3 at{d * std::cos(1.0), kRim + random.uniform(0.001, 0.0075), d * std::sin(1.0)};
    const Press press = press_rim(clay, still(at, 1e-5), kClay);
    const double felt = 5e6 * brute_up(def.inner_radius, def.outer_radius, at, kRim, true);
    const double moved = brute_up(def.inner_radius, def.outer_radius, at, kRim);
    EXPECT_NEAR(press.force.y, felt, 0.02 * felt + 1e-4) << round;
    // And the ring goes down by what is pressed of it.
    const double ring =
        portable::kPi * (std::pow(def.outer_radius, 2) - std::pow(def.inner_radius, 2));
    const double sunk = moved / ring * 1e-5 / kTau;
    EXPECT_NEAR(kRim - clay.rim_height(), sunk, 0.03 * sunk + 1e-11) << round;
  }
}

TEST(Rim, AHeldPressIsTheSameAtAnyTickLengthAndFollowsTheLawInTinySteps) {
  // A ball that plugs a narrow mouth: every sector is pressed.
  ClayDef def = cylinder(200, 180);
  def.outer_radius = 0.0105;
  def.inner_radius = 0.006;
  def.radius_max = 0.0105001;  // so that it cannot get out of the way
  const Vec3 at{0, kRim + 0.003, 0};
  const double ring =
      portable::kPi * (std::pow(def.outer_radius, 2) - std::pow(def.inner_radius, 2));
  double rim = kRim;
  for (int n = 0; n < 40; ++n) rim -= brute_up(0.006, 0.0105, at, rim) / ring * 0.0005 / kTau;
  for (double dt : {0.00025, 0.001, 0.005}) {
    Clay clay = lump(def);
    for (int n = 0; n < static_cast<int>(0.02 / dt + 0.5); ++n)
      press_rim(clay, still(at, dt), kClay);
    EXPECT_NEAR((kRim - clay.rim_height()) / (kRim - rim), 1.0, 0.01) << dt;
  }
}

TEST(Rim, FeelsAndGivesWayTheSameOnEveryGrid) {
  double up[3], height[3], mouth[3];
  for (int which : {0, 1, 2}) {
    Clay clay = lump(cylinder(200 << which, 180 << which));
    Turning hand{clay};
    hand.move({0.0505, kRim + kRadius + 0.001, 0}, {0.0505, kRim + kRadius - 0.006, 0}, 1000);
    up[which] = hand.last.force.y;
    height[which] = kRim - clay.rim_height();
    mouth[which] = clay.profile().outer_at(kRim) - 0.055;
  }
  for (int which : {0, 1}) {
    EXPECT_NEAR(up[which] / up[2], 1.0, 0.03);
    EXPECT_NEAR(height[which] / height[2], 1.0, 0.03);
    EXPECT_NEAR(mouth[which] / mouth[2], 1.0, 0.05);
  }
}

TEST(Rim, NothingJumpsWhereAToolSlidesFromTheWallOverTheRimIntoTheMouth) {
  // Every place on a fresh pot, so that only the choice of place could make the force jump.
  for (double deep : {0.0005, 0.002, 0.004}) {
    double most = 0.0, jump = 0.0;
    Vec3 last;
    for (double d = 0.064; d > 0.040; d -= 2e-5) {
      Clay clay = lump();
      ToolContact contact;
      const Vec3 at{d, kRim + kRadius - deep, 0};
      const ToolSweep sweep = sweep_sphere(at, at, kRadius);
      contact.begin_tick();
      contact.step(clay, sweep, 0, 1, kClay);
      const Vec3 force = contact.reaction().force;
      most = std::max(most, length(force));
      jump = std::max(jump, length(force - last));
      last = force;
    }
    EXPECT_LT(jump, 0.15 * most) << deep;
  }
}

TEST(Rim, RowsPressedTogetherAreFirmAtAQuarterOfTheirHeight) {
  ClayDef def = cylinder(80, 90);
  def.height = 0.03;
  def.outer_radius = 0.0105;
  def.inner_radius = 0.006;
  def.radius_max = 0.0105001;  // so that it cannot get out of the way
  Clay clay = lump(def);
  Press press;
  double y = 0.03 + kRadius;
  for (int n = 0; n < 20000; ++n) {
    y = std::max(y - 1e-5, 0.012);
    press = press_rim(clay, still({0, y, 0}), kClay);
  }
  // The floor's 10 mm, with the row over it, stay as they are.
  const double row = 0.03 / 80;
  EXPECT_NEAR(clay.rim_height(), 28 * row + 52 * 0.25 * row, 0.1 * row);
  EXPECT_GT(press.force.y, 1.0);
  expect_whole(clay);
}

TEST(Rim, TheTopOfASolidLumpIsARimFarFromItsMiddleAndGoesDownAsAWhole) {
  ClayDef def = cylinder(100, 180);
  def.height = def.floor_thickness = 0.1;
  Clay clay = lump(def);
  Turning hand{clay};
  hand.move({0.045, 0.1 + kRadius, 0}, {0.045, 0.1 + kRadius - 0.004, 0}, 2000);
  EXPECT_EQ(hand.contact.place(), Place::rim);
  EXPECT_LT(clay.rim_height(), 0.0995);
  EXPECT_EQ(clay.floor_rows(), 100);
  EXPECT_EQ(clay.floor_top(), clay.rim_height());
  EXPECT_GT(hand.last.force.y, 0.1);
  expect_whole(clay);
}

TEST(Rim, AThinLipIsHalfATorusAThickOneHasRoundEdgesAndASolidTopOnlyOne) {
  for (double x = 0.0; x <= 0.0041; x += 0.0005)
    EXPECT_NEAR(std::hypot(x - 0.002, 0.002 - lip_drop(0.05, 0.054, 0.05 + x)), 0.002, 1e-12) << x;
  EXPECT_EQ(lip_drop(0.02, 0.05, 0.0231), 0.0);
  EXPECT_EQ(lip_drop(0.02, 0.05, 0.035), 0.0);
  EXPECT_NEAR(lip_drop(0.02, 0.05, 0.02), 0.003, 1e-15);
  EXPECT_NEAR(lip_drop(0.02, 0.05, 0.05), 0.003, 1e-15);
  EXPECT_EQ(lip_drop(0.0, 0.05, 0.0), 0.0);
  EXPECT_NEAR(lip_drop(0.0, 0.05, 0.05), 0.003, 1e-15);
}

TEST(Rim, ComesToRest) {
  Clay clay = lump(cylinder(100, 90));
  std::int64_t touched = 1;
  for (int n = 0; n < 200000 && touched > 0; ++n)
    touched = press_rim(clay, still({0.052, kRim + kRadius - 1e-5, 0}, 0.005), kClay).touched;
  EXPECT_EQ(touched, 0);
}

TEST(Rim, RandomTicksKeepTheClayWhole) {
  Random random(12);
  for (int round = 0; round < 6; ++round) {
    ClayDef def = cylinder(60, 48);
    def.height = 0.06;
    def.floor_thickness = round % 3 == 0 ? 0.06 : 0.006;
    def.inner_radius = random.uniform(0.003, 0.049);
    Clay clay = lump(def);
    Turning hand{clay};
    Vec3 at{random.uniform(-0.05, 0.05), 0.08, random.uniform(-0.05, 0.05)};
    for (int n = 0; n < 20000; ++n) {
      const double pace = random.uniform() < 0.02 ? 0.004 : 0.0004;
      Vec3 to = at + Vec3{random.uniform(-pace, pace), random.uniform(-pace, pace),
                          random.uniform(-pace, pace)};
      to = {std::clamp(to.x, -0.07, 0.07), std::clamp(to.y, 0.0, 0.08),
            std::clamp(to.z, -0.07, 0.07)};
      if (random.uniform() < 0.005) hand.contact.release();
      hand.tick(at, to, random.uniform(-0.03, 0.06));
      ASSERT_TRUE(is_finite(hand.last.force));
      at = to;
    }
    expect_whole(clay);
  }
}

// A ball that stands 6 mm deep in a spout no wider than itself, for as long as clay takes to give
// way wholly: what is too much for one step is left to the next.
TEST(Rim, ABlowTakesNoMoreThanHalfOfWhatARowCanGive) {
  ClayDef def = cylinder(400, 64);
  def.inner_radius = 0.004;
  def.outer_radius = 0.0085;
  Clay clay = lump(def);
  const double row = clay.row_thickness(399);
  press_rim(clay, still({0, kRim + kRadius - 0.006, 0}, 10.0), kClay);
  EXPECT_LT(clay.rim_height(), kRim - 0.002);
  for (int j = 0; j < clay.rows(); ++j) ASSERT_GE(clay.row_thickness(j), 0.5 * row) << j;
}

// NUMERICS, row 19: no rim, and nothing pushes up. The printed model on the same turn.
TEST(Paper19, NoRimGoesDown) {
  double up[2] = {0, 0};
  const auto lowered = [&](bool as_printed) {
    Clay clay = lump(cylinder(200, 180));
    const double before = clay.rim_height();
    PaperModel model(clay);
    Turning hand{clay};
    for (int n = 0; n < 1000; ++n) {
      const Vec3 at{0.052, kRim + kRadius - 4e-6 * n, 0};
      if (as_printed) {
        up[0] += model.tick(clay, WallSide::outside, at, kRadius, 0.018 * n, 0.018, {}).force.y;
      } else {
        hand.tick(at, at, 0.018);
        up[1] += hand.last.force.y;
      }
    }
    return before - clay.rim_height();
  };
  EXPECT_EQ(lowered(true), 0.0);
  EXPECT_GT(lowered(false), 0.001);
  EXPECT_EQ(up[0], 0.0);
  EXPECT_GT(up[1] / 1000, 0.1);
}

}  // namespace
}  // namespace onggi::rim_test
