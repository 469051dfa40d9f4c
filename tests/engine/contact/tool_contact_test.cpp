#include "engine/contact/tool_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/stops.h"
#include "engine/math/random.h"
#include "tests/engine/contact/cone.h"
#include "tests/support/sphere.h"

namespace onggi::tool_contact_test {
namespace {

constexpr Yielding kClay{0.00949, 5e6};
constexpr double kRadius = 0.008;

Clay lump(int sectors = 360) {
  ClayDef def;
  def.sectors = sectors;
  return std::move(*Clay::create(def));
}

// One tick: `contact` goes from `from` to `to` while the wheel turns by `turn`.
void tick(ToolContact& contact, Clay& clay, Vec3 from, Vec3 to, double angle = 0.0,
          double turn = 0.0, SideWish wish = SideWish::by_position) {
  const ToolSweep sweep = sweep_sphere(from, to, kRadius, angle, turn, wish);
  const int steps = steps_for(sweep, kClay.relaxation_time, contact.pressed());
  contact.begin_tick();
  for (int n = 0; n < steps; ++n) contact.step(clay, sweep, n, steps, kClay);
}

TEST(Side, IsWhereTheToolStandsUnlessWishedAndPossible) {
  Clay clay = lump();
  const auto side_at = [&](Vec3 at, SideWish wish) {
    ToolContact contact;
    tick(contact, clay, at, at, 0, 0, wish);
    return contact.side();
  };
  const Vec3 beside{0.08, 0.1, 0}, within{0.01, 0.1, 0}, above{0.03, 0.3, 0};
  EXPECT_EQ(side_at(beside, SideWish::by_position), WallSide::outside);
  EXPECT_EQ(side_at(within, SideWish::by_position), WallSide::inside);
  EXPECT_EQ(side_at(above, SideWish::outside), WallSide::outside);
  EXPECT_EQ(side_at(above, SideWish::inside), WallSide::inside);
  EXPECT_EQ(side_at(beside, SideWish::inside), WallSide::outside);  // not through the wall
  EXPECT_EQ(side_at(within, SideWish::outside), WallSide::inside);
}

TEST(Side, AWishNeverCutsTheWallAway) {
  Clay clay = lump();
  ToolContact contact;
  // Lowered into the pot while "outside" is wished.
  for (double y = 0.25; y > 0.1; y -= 0.001)
    tick(contact, clay, {0.005, y + 0.001, 0}, {0.005, y, 0}, 0, 0, SideWish::outside);
  EXPECT_NEAR(clay.profile().outer_at(0.15), 0.055, 1e-6);
  EXPECT_NEAR(clay.profile().outer_at(0.199), 0.055, 1e-6);
}

TEST(Side, NeverChattersWhileAToolTremblesOnATurningWall) {
  Clay clay = lump();
  ToolContact contact;
  Random random(4);
  Vec3 last{0.0630, 0.1, 0};
  int changes = 0;
  WallSide side = WallSide::outside;
  for (int n = 0; n < 4000; ++n) {
    // Pressed right through to a thin wall, trembling by an encoder's step.
    const double x = std::max(0.0630 - n * 1e-5, 0.030) + random.uniform(-55e-6, 55e-6);
    const Vec3 at{x, 0.1 + random.uniform(-55e-6, 55e-6), random.uniform(-55e-6, 55e-6)};
    tick(contact, clay, last, at, n * 0.02, 0.02);
    changes += contact.side() != side;
    side = contact.side();
    last = at;
  }
  EXPECT_EQ(changes, 0);
}

TEST(Side, ChangesOnceWhenTheToolIsCarriedOverTheRim) {
  Clay clay = lump();
  ToolContact contact;
  int changes = 0;
  WallSide side = WallSide::outside;
  Vec3 last{0.064, 0.203, 0};
  tick(contact, clay, last, last);
  for (double x = 0.064; x > 0.005; x -= 0.003) {
    const Vec3 at{x, 0.203, 0};  // the rim is at 0.2: the tool brushes over it, too fast to push it
    tick(contact, clay, last, at);
    changes += contact.side() != side;
    side = contact.side();
    last = at;
  }
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(side, WallSide::inside);
}

TEST(Sweep, StepsKeepTheToolWithinAQuarterRadiusAndTheClayWithinAnEighth) {
  const auto steps = [](Vec3 from, Vec3 to, double turn, double tau = kClay.relaxation_time) {
    return steps_for(sweep_sphere(from, to, kRadius, 0.0, turn), tau);
  };
  const Vec3 at{0.06, 0, 0};
  EXPECT_EQ(steps(at, at, 0.0), 1);
  EXPECT_EQ(steps(at, {0.06, 0.0081, 0}, 0.0), 5);
  EXPECT_EQ(steps(at, at, 0.1), 6);
  EXPECT_EQ(steps({9, 0, 0}, {-9, 0, 0}, 0.0), 256) << "a hand that leaps costs no tick more";
  EXPECT_EQ(steps(at, at, 0.0, 0.001), 4);  // and no longer than a quarter of the relaxation time
}

TEST(Sweep, AToolThatPressesIsCountedByTheClayUnderItNotByItsMiddle) {
  const auto steps = [](double distance, double turn, std::optional<WallSide> pressed) {
    const Vec3 at{distance, 0, 0};
    return steps_for(sweep_sphere(at, at, kRadius, 0.0, turn), kClay.relaxation_time, pressed);
  };
  // 54.5 mm from the axis clay passes by 0.98 mm, an eighth of the ball is 1 mm.
  EXPECT_EQ(steps(0.0625, 0.018, WallSide::outside), 1);
  EXPECT_EQ(steps(0.0625, 0.018, std::nullopt), 2);
  // And 58 mm from it by 1.04.
  EXPECT_EQ(steps(0.05, 0.018, WallSide::inside), 2);
  EXPECT_EQ(steps(0.05, 0.018, std::nullopt), 1);
  // A ball that reaches to the axis is pressed beside it, too.
  EXPECT_EQ(steps(0.008, 1.0, WallSide::outside), 4);
}

ToolSweep sweep_rib(Vec3 at, double roll, double angle, double turn, bool inside) {
  const ToolShape& rib = *find_tool_shape("flat_rib");
  const ToolPlace held = hold_tool(rib, at, {}, roll, inside);
  ToolSweep sweep = sweep_sphere(at, at, kRadius, angle, turn);
  sweep.shape = &rib;
  sweep.size = sized(rib, {});
  sweep.along = held.along;
  sweep.across = held.across;
  return sweep;
}

TEST(Sweep, ClayComesToAFlatRibsFaceAsToAFingertipAndToItsEdgesAsToAnEdge) {
  const auto steps = [](double roll, double turn, std::optional<WallSide> pressed) {
    const ToolSweep rib = sweep_rib({0.056, 0.1, 0}, roll, 0.0, turn, pressed == WallSide::inside);
    return steps_for(rib, kClay.relaxation_time, pressed);
  };
  EXPECT_EQ(steps(0.0, 0.0178, WallSide::outside), 1);  // 1 mm of clay, a fingertip of 8
  EXPECT_EQ(steps(0.0, 0.0178, std::nullopt), 3);       // 1 mm of clay, a plate of 3
  EXPECT_EQ(steps(0.0, 0.0178, WallSide::inside), 3);   // a hollow meets both its edges
  EXPECT_EQ(steps(0.5 * 3.14159265, 0.0178, WallSide::outside), 3);  // edge on
  EXPECT_EQ(steps(0.25, 0.0178, WallSide::outside), 2);  // 6 mm from where it is nearest to an edge
}

TEST(Sweep, OneStepATickIsAsGoodAsSixteenWhereThatIsAllItAsksFor) {
  // Two turns of a light touch that rises: what is left differs by a tenth of what a force device
  // can tell, and the force by a thousandth.
  struct Trial {
    const char* name;
    ToolSweep (*sweep)(double height, double angle, double turn);
  };
  const Trial trials[] = {{"finger",
                           [](double height, double angle, double turn) {
                             const Vec3 at{0.0625, height, 0};
                             return sweep_sphere(at, at, kRadius, angle, turn, SideWish::outside);
                           }},
                          {"rib", [](double height, double angle, double turn) {
                             return sweep_rib({0.056, height, 0}, 0.0, angle, turn, false);
                           }}};
  for (const Trial& trial : trials) {
    SCOPED_TRACE(trial.name);
    Clay clay[2] = {lump(), lump()};
    double force[2] = {};
    for (int which : {0, 1}) {
      ToolContact contact;
      for (int n = 0; n < 700; ++n) {
        const ToolSweep sweep = trial.sweep(0.1 + 2e-5 * n, 0.0175 * n, 0.0175);
        const int asked = steps_for(sweep, kClay.relaxation_time, contact.pressed());
        EXPECT_EQ(asked, n > 0 ? 1 : asked);
        const int steps = which == 0 ? 1 : 16;
        contact.begin_tick();
        for (int k = 0; k < steps; ++k) contact.step(clay[which], sweep, k, steps, kClay);
        if (n >= 350) force[which] += contact.reaction().force.x;
      }
    }
    EXPECT_NEAR(force[0] / force[1], 1.0, 1e-3);
    float most = 0.0f;
    for (int j = 0; j < clay[0].rows(); ++j)
      for (std::size_t i = 0; i < 360; ++i)
        most = std::max(most, std::fabs(clay[0].outer(j)[i] - clay[1].outer(j)[i]));
    EXPECT_LT(most, 5.5e-6f);
  }
}

TEST(Sweep, AFastToolDoesNotTunnelThroughTheWall) {
  // 30 mm a tick, past the wall's 33 mm: without a sweep it would be outside, then inside.
  Clay fast = lump();
  ToolContact contact;
  tick(contact, fast, {0.070, 0.1, 0}, {0.070, 0.1, 0});
  tick(contact, fast, {0.070, 0.1, 0}, {0.040, 0.1, 0});
  EXPECT_EQ(contact.side(), WallSide::outside);
  EXPECT_GT(contact.reaction().force.x, 0.0);
  EXPECT_LT(fast.outer(200)[0], 0.0545f);
  tick(contact, fast, {0.040, 0.1, 0}, {0.010, 0.1, 0});
  EXPECT_EQ(contact.side(), WallSide::outside);  // it is in the clay, not in the pot
}

TEST(Sweep, NoElementIsSkippedHoweverFastTheWheelOrFineTheSectors) {
  // 300 rpm for 2 s; light touch. At 1440 sectors a tick passes seven.
  double mean[2];
  for (int which : {0, 1}) {
    Clay clay = lump(which == 0 ? 360 : 1440);
    ToolContact contact;
    const Vec3 at{0.0627, clay.row_height(200), 0};
    const double turn = 31.4159 * 0.001;
    for (int n = 0; n < 2000; ++n) tick(contact, clay, at, at, n * turn, turn);
    // Smooth round the pot to a few micrometres (a step of the tool is an eighth of its radius),
    // but for the tool's own place between two turns.
    const auto row = clay.outer(200);
    const std::size_t count = row.size();
    int rough = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float neighbours = 0.5f * (row[(i + count - 1) % count] + row[(i + 1) % count]);
      rough += std::fabs(row[i] - neighbours) > 5e-6f;
      EXPECT_LT(row[i], 0.05495f);
    }
    EXPECT_LT(rough, 0.05 * static_cast<double>(count));
    mean[which] = clay.profile().outer_at(clay.row_height(200));
  }
  EXPECT_NEAR(mean[0], mean[1], 1e-6);
}

TEST(Sweep, TheSmallestBallOnTheFastestWheelMissesNoElementInTheLongestTicks) {
  ClayDef def;
  def.rows = 40;
  def.sectors = 2880;
  def.height = 0.02;
  Clay clay = std::move(*Clay::create(def));
  ToolContact contact;
  const Vec3 at{0.055995, clay.row_height(20), 0};  // 5 um deep
  const double turn = 62.8318530718 * 0.005;        // a twentieth of a turn
  for (int n = 0; n < 21; ++n) {
    ToolSweep sweep = sweep_sphere(at, at, 0.001, n * turn, turn, SideWish::outside);
    sweep.seconds = 0.005;
    const int steps = steps_for(sweep, kClay.relaxation_time, contact.pressed());
    contact.begin_tick();
    for (int k = 0; k < steps; ++k) contact.step(clay, sweep, k, steps, kClay);
  }
  EXPECT_EQ(std::ranges::count(clay.outer(20), clay.outer(0)[0]), 0);
}

TEST(Sweep, TurningTheWheelIsTheSameAsCarryingTheToolRound) {
  Clay turned = lump();
  Clay carried = lump();
  ToolContact a;
  ToolContact b;
  Press pa, pb;
  for (int n = 0; n < 100; ++n) {
    tick(a, turned, {0.062, 0.1, 0}, {0.062, 0.1, 0}, n * 0.001, 0.001);
    const double from = -n * 0.001;
    const double to = -(n + 1) * 0.001;
    tick(b, carried, {0.062 * std::cos(from), 0.1, 0.062 * std::sin(from)},
         {0.062 * std::cos(to), 0.1, 0.062 * std::sin(to)});
    pa = a.reaction();
    pb = b.reaction();
    EXPECT_NEAR(pa.normal, pb.normal, 1e-3 * pa.normal + 1e-7);
  }
  for (std::size_t i = 0; i < 360; ++i)
    EXPECT_NEAR(turned.outer(200)[i], carried.outer(200)[i], 1e-6);
}

// The largest change of the push, N, over a micrometre, as a ball goes over a frozen wall, `above`
// m over its crown, from `from` to `to`.
double largest_step(Clay& clay, double above, double from, double to) {
  constexpr Yielding kFrozen{1e6, 5e6};
  ToolContact contact;
  double most = 0.0;
  Vec3 last;
  const int steps = static_cast<int>(1e6 * std::fabs(to - from));
  for (int n = 0; n <= steps; ++n) {
    const Vec3 at{from + (to - from) * n / steps, kRim + above, 0.0004};
    contact.begin_tick();
    contact.step(clay, sweep_sphere(at, at, kRadius), 0, 1, kFrozen);
    const Vec3 force = contact.reaction().force;
    if (n > 0) most = std::max(most, length(force - last));
    last = force;
  }
  return most;
}

// Of a wall that leans the edge's law feels rows below the rim, too, where no sector of the rim
// lies under the ball: the force stepped by 24 mN.
TEST(Edge, OfAWallThatLeansIsTouchedAndLeftWithoutAStep) {
  for (const double slope : {-1.0, 1.0})
    for (const double thick : {0.004, 0.012}) {
      Clay clay = cone(slope, thick, 0.15);
      const double middle = 0.15 + slope * 0.5 * kRim - 0.5 * thick;
      for (const double above : {0.3 * kRadius, 0.5 * kRadius})
        for (const double side : {-1.0, 1.0}) {
          const double clear = middle + side * (0.5 * thick + kRadius + 0.0005);
          const double deep = middle + side * (0.5 * thick + kRadius - 0.004);
          EXPECT_LT(largest_step(clay, above, clear, deep), 0.002)
              << slope << ", " << thick << ", " << above << ", " << side;
          EXPECT_LT(largest_step(clay, above, deep, clear), 0.002)
              << slope << ", " << thick << ", " << above << ", " << side;
        }
    }
}

TEST(Stops, AFlatStopPushesWithTheVolumeOfTheCoveredCapAndStartsSmoothly) {
  EXPECT_EQ(stop_force(-0.001, kRadius, 5e6), 0.0);
  EXPECT_EQ(stop_force(0.0, kRadius, 5e6), 0.0);
  EXPECT_LT(stop_force(1e-5, kRadius, 5e6), 1e-4);
  const double sphere = 4.0 / 3.0 * 3.14159265358979 * kRadius * kRadius * kRadius;
  EXPECT_NEAR(stop_force(kRadius, kRadius, 5e6), 5e6 * sphere / 2, 1e-9);
  EXPECT_NEAR(stop_force(1.0, kRadius, 5e6), 5e6 * sphere, 1e-9);
}

}  // namespace
}  // namespace onggi::tool_contact_test
