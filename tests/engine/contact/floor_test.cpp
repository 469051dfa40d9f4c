#include "engine/contact/floor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/contact/tool_contact.h"
#include "engine/math/portable.h"
#include "tests/support/sphere.h"

namespace onggi::floor_test {
namespace {

constexpr double kTau = 0.00949;
constexpr Yielding kClay{kTau, 5e6};
constexpr double kRadius = 0.008;

// A lump that nobody has opened yet.
ClayDef solid(int rows = 200, int sectors = 180) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.height = 0.1;
  def.floor_thickness = 0.1;
  return def;
}
Clay lump(const ClayDef& def) { return std::move(*Clay::create(def)); }

// A ball whose lowest point goes from `from` to `to`, `off` the axis.
BallStep ball(double from, double to, double seconds, double off = 0.0) {
  return {{off, from + kRadius, 0}, {off, to + kRadius, 0}, kRadius, seconds};
}

Press tick(ToolContact& contact, Clay& clay, Vec3 from, Vec3 to, double angle = 0.0,
           double turn = 0.0) {
  const ToolSweep sweep = sweep_sphere(from, to, kRadius, angle, turn);
  const int steps = steps_for(sweep, kClay.relaxation_time, contact.pressed());
  contact.begin_tick();
  for (int n = 0; n < steps; ++n) contact.step(clay, sweep, n, steps, kClay);
  return contact.reaction();
}

// A fingertip lowered at `speed` on a turning wheel, from just above the lump to `lowest`.
std::vector<Press> open(Clay& clay, double lowest, double speed = 0.02, double off = 0.0) {
  ToolContact contact;
  std::vector<Press> felt;
  double y = clay.rim_height() + 0.001;
  for (int n = 0; y > lowest; ++n) {
    const double next = std::max(y - 0.001 * speed, lowest);
    felt.push_back(
        tick(contact, clay, {off, y + kRadius, 0}, {off, next + kRadius, 0}, 0.02 * n, 0.02));
    y = next;
  }
  return felt;
}

TEST(Floor, OpeningALumpMakesAHoleOfTheToolsSizeAndStopsAtTheThinnestFloor) {
  Clay clay = lump(solid());
  open(clay, 0.002);
  EXPECT_EQ(clay.floor_top(), 0.004);
  EXPECT_EQ(clay.floor_rows(), 8);  // of 0.5 mm
  const Profile p = clay.profile();
  EXPECT_NEAR(p.floor_height(), 0.004, 0.0005);
  for (double h = 0.012; h < 0.1; h += 0.004) {
    EXPECT_NEAR(p.inner_at(h), kRadius, 0.0003) << h;
    EXPECT_EQ(p.outer_at(h), double{0.055f});
  }
  // Round at its bottom, as the tool is: its lowest point stands at 2 mm.
  EXPECT_NEAR(p.inner_at(0.005), std::sqrt(0.003 * (0.016 - 0.003)), 0.0004);
}

TEST(Floor, AHeldPressDecaysAsAMaxwellElementAtAnyTickLength) {
  for (double dt : {0.00025, 0.001, 0.005}) {
    Clay clay = lump(solid());
    for (int n = 0; n < static_cast<int>(0.02 / dt + 0.5); ++n)
      press_floor(clay, ball(0.098, 0.098, dt), kClay);
    EXPECT_NEAR(clay.floor_top(), 0.098 + 0.002 * std::exp(-0.02 / kTau), 1e-12) << dt;
  }
}

TEST(Floor, FollowsAToolThatSinksEvenlyExactly) {
  for (double dt : {0.0005, 0.002, 0.005}) {
    Clay clay = lump(solid());
    const double speed = 0.03;
    // Begins a little above, so that one step has touch for a part of it only.
    double y = 0.1 + 0.0003 * speed;
    double t = -0.0003;
    while (t < 0.0296) {
      press_floor(clay, ball(y, y - speed * dt, dt), kClay);
      y -= speed * dt;
      t += dt;
    }
    EXPECT_NEAR(clay.floor_top() - y, speed * kTau * (1.0 - std::exp(-t / kTau)), 1e-9) << dt;
  }
}

// The wall's law on an endless flat floor: depth times the upright share of the ball's normal,
// summed over the cap, (2 pi / r) (r^4/4 - h r^3/3 + h^4/12) with h = r - depth.
double upright_cap(double l) {
  const double h = kRadius - l;
  return 2 * portable::kPi / kRadius *
         (std::pow(kRadius, 4) / 4 - h * std::pow(kRadius, 3) / 3 + std::pow(h, 4) / 12);
}

TEST(Floor, PushesUpByTheWallsLaw) {
  Clay clay = lump(solid());
  const double l = 0.001;
  const Press press = press_floor(clay, ball(0.1 - l, 0.1 - l, 1e-6), kClay);
  EXPECT_NEAR(press.force.y, 5e6 * upright_cap(l), 2e-4);
  EXPECT_EQ(press.force.x, 0.0);
  EXPECT_EQ(press.force.z, 0.0);
  EXPECT_EQ(press.normal, press.force.y);
}

TEST(Floor, TheSameForceOpensTheLumpOnEveryGrid) {
  double mean[3];
  double most[3];
  for (int which : {0, 1, 2}) {
    Clay clay = lump(solid(100 << which, 90 << which));
    const std::vector<Press> felt = open(clay, 0.05);
    mean[which] = most[which] = 0.0;
    for (const Press& p : felt) {
      mean[which] += p.force.y / static_cast<double>(felt.size());
      most[which] = std::max(most[which], p.force.y);
    }
  }
  EXPECT_GT(mean[2], 0.02);
  for (int which : {0, 1}) {
    EXPECT_NEAR(mean[which] / mean[2], 1.0, 0.05);
    EXPECT_NEAR(most[which] / most[2], 1.0, 0.15);  // the edge of a hole one row deep
  }
}

TEST(Floor, NothingJumpsWhereARowComesFree) {
  Clay clay = lump(solid());
  const std::vector<Press> felt = open(clay, 0.05, 0.01);  // a row in 50 ticks
  double most = 0.0;
  double jump = 0.0;
  for (std::size_t n = 1; n < felt.size(); ++n) {
    most = std::max(most, felt[n].force.y);
    jump = std::max(jump, std::fabs(felt[n].force.y - felt[n - 1].force.y));
  }
  EXPECT_LT(jump, 0.13 * most);
}

TEST(Floor, OffTheAxisGivesWayByTheShareThatTheToolCovers) {
  // Displaced: the print's area times the depth, spread over the disc out to the tool's far edge.
  const double l = 0.001;
  const double print = std::sqrt(l * (2 * kRadius - l));
  for (double off : {0.0, 0.004, 0.015}) {
    Clay clay = lump(solid());
    const double dt = 1e-4;
    press_floor(clay, ball(0.1 - l, 0.1 - l, dt, off), kClay);
    const double volume = (0.1 - clay.floor_top()) * portable::kPi * std::pow(print + off, 2);
    EXPECT_NEAR(volume, portable::kPi * print * print * l * dt / kTau, 0.01 * volume) << off;
  }
}

TEST(Floor, AToolDrawnOutwardsAfterwardsWidensTheHole) {
  Clay clay = lump(solid());
  ToolContact contact;
  open(clay, 0.02);
  Vec3 at{0, 0.021 + kRadius, 0};
  for (int n = 0; n < 2000; ++n) {
    const Vec3 to{at.x + 1e-5, at.y, 0};
    tick(contact, clay, at, to, 0.02 * n, 0.02);
    at = to;
  }
  for (int n = 0; n < 1000; ++n) tick(contact, clay, at, at, 0.02 * n, 0.02);
  const Profile p = clay.profile();
  EXPECT_NEAR(p.inner_at(0.021 + kRadius), 0.028, 0.0005);
  EXPECT_NEAR(p.inner_at(0.08), kRadius, 0.0003);
  EXPECT_LT(clay.floor_top(), 0.0215);
}

TEST(Floor, IsFirmAtItsThinnestAndWhereAToolIsFoundDeepInIt) {
  ClayDef def;
  def.floor_thickness = 0.004;
  Clay thin = lump(def);
  Press press;
  for (int n = 0; n < 500; ++n) press = press_floor(thin, ball(0.003, 0.003, 0.001), kClay);
  EXPECT_EQ(thin.floor_top(), 0.004);
  EXPECT_NEAR(press.force.y, 5e6 * upright_cap(0.001), 1e-9);

  Clay clay = lump(solid());
  const std::uint64_t before = clay.hash();
  for (int n = 0; n < 500; ++n) press = press_floor(clay, ball(0.05, 0.05, 0.001), kClay);
  EXPECT_EQ(clay.hash(), before);
  EXPECT_GT(press.force.y, 1.0);
}

TEST(Floor, AHeldToolComesToRestBitForBit) {
  Clay clay = lump(solid());
  for (int n = 0; n < 1000; ++n) press_floor(clay, ball(0.097, 0.097, 0.001), kClay);
  const std::uint64_t settled = clay.hash();
  EXPECT_EQ(press_floor(clay, ball(0.097, 0.097, 0.001), kClay).touched, 0);
  EXPECT_EQ(clay.hash(), settled);
}

TEST(Floor, AToolIsReportedOnTheFloorWhileItPressesIt) {
  Clay clay = lump({});
  ToolContact contact;
  tick(contact, clay, {0, 0.1, 0}, {0, 0.1, 0});
  EXPECT_EQ(contact.place(), Place::inside);
  const Vec3 on_floor{0, 0.010 + kRadius - 0.0005, 0};
  tick(contact, clay, on_floor, on_floor);
  EXPECT_EQ(contact.place(), Place::floor);
  EXPECT_EQ(contact.side(), WallSide::inside);
  tick(contact, clay, on_floor, on_floor + Vec3{0, 0.01, 0});
  tick(contact, clay, on_floor + Vec3{0, 0.01, 0}, on_floor + Vec3{0, 0.01, 0});
  EXPECT_EQ(contact.place(), Place::inside);
}

// Rows are pressed 32 at a time: the floor's edge lies in each such lot in turn, above and below.
TEST(Press, OfFirmClayWallsGoAsAWholeAndTheFloorGivesNoWayWhereverItEnds) {
  ClayDef def;
  def.rows = 1000;
  def.sectors = 90;
  def.floor_thickness = 0.1;
  for (double y = 0.0942; y <= 0.1026; y += 0.0002) {
    Clay soft = lump(def);
    soft.keep_areas();
    Clay firm = soft;
    firm.areas()->harden_all(true, false);
    for (Clay* clay : {&soft, &firm})
      press_sphere(*clay, WallSide::outside, {0.061, y, 0.0}, kRadius, 0.001, kClay);
    for (int j = 0; j < firm.rows(); ++j) {
      const float was = 0.055f, now = firm.outer(j)[0];
      if (j < firm.floor_rows()) {
        ASSERT_EQ(now, was) << "row " << j << " of the floor, hand at " << y;
        continue;
      }
      ASSERT_EQ(now < was, soft.outer(j)[0] < was) << "row " << j << ", hand at " << y;
      const float within = firm.inner(j)[0];
      ASSERT_NEAR(now * now - within * within, was * was - 0.022f * 0.022f, 1e-8)
          << "row " << j << ", hand at " << y;
    }
  }
}

}  // namespace
}  // namespace onggi::floor_test
