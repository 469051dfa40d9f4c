#include "engine/force/coupling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace onggi::force::coupling_test {
namespace {

constexpr double kTick = 0.001;

/// A wall of `stiffness` N/m below y = 0, and what a coupling meets of it.
Touch wall(Vec3 tool, double stiffness, double grip = 0.0, Vec3 clay = {}) {
  if (tool.y >= 0.0) return {};
  return {{0.0, -stiffness * tool.y, 0.0}, stiffness, 0.0, grip, clay};
}

TEST(Coupling, ClearOfTheClayHandAndToolAreOneHoweverFast) {
  Coupling coupling;
  const CouplingLimits limits{50.0, 3.3};
  for (int n = 0; n < 100; ++n) {
    const Vec3 hand{0.002 * n, 0.1, -0.001 * n};
    EXPECT_EQ(coupling.tool(hand, kTick, limits), hand);
    EXPECT_EQ(coupling.feel({}, limits), Vec3{});
  }
}

TEST(Coupling, IsASpringInSeriesWithTheWallAtBothEndsOfItsRange) {
  for (const double stiffness : {10.0, 300.0, 1e5})
    for (const double hard : {50.0, 1500.0, 1e5}) {
      Coupling coupling;
      const CouplingLimits limits{stiffness, 1e9};
      const double series = stiffness * hard / (stiffness + hard);
      Vec3 force;
      double last = 0.0, steepest = 0.0;
      for (int n = 1; n <= 400; ++n) {
        const double y = -1e-5 * std::min(n, 300);
        const Vec3 tool = coupling.tool({0.0, y, 0.0}, kTick, limits);
        force = coupling.feel(wall(tool, hard), limits);
        steepest = std::max(steepest, (force.y - last) / 1e-5);
        last = force.y;
      }
      EXPECT_NEAR(force.y / (series * 3e-3), 1.0, 1e-3) << stiffness << ' ' << hard;
      EXPECT_LT(steepest, 1.001 * stiffness);
    }
}

TEST(Coupling, LeavesClayThatGivesWayAsHeavyAsItWas) {
  // A dashpot of 4 N s/m behind 500 N/m: Maxwell's clay. At 20 mm/s it takes 0.08 N, however soft
  // the spring before it, and although the tool is felt in a mean.
  for (const double stiffness : {20.0, 2000.0}) {
    Coupling coupling;
    const CouplingLimits limits{stiffness, 3.3};
    const double keeps = std::exp(-kTick * 500.0 / 4.0);
    double push = 0.0, last = 0.0;
    Vec3 force;
    for (int n = 1; n <= 3000; ++n) {
      const Vec3 tool = coupling.tool({0.0, -2e-5 * n, 0.0}, kTick, limits);
      const double way = n == 1 ? 0.0 : last - tool.y;
      last = tool.y;
      push = std::max(0.0, keeps * push + 4.0 * (1.0 - keeps) * way / kTick);
      force = coupling.feel({{0.0, push, 0.0}, 500.0, 4.0 / 500.0, 0.0, {}}, limits);
    }
    EXPECT_NEAR(force.y, 0.02 * 4.0, 0.002) << stiffness;
  }
}

TEST(Coupling, FrictionHoldsUntilItsGripAndThenLetsSlide) {
  Coupling coupling;
  const CouplingLimits limits{200.0, 3.3};
  Vec3 force;
  for (int n = 0; n < 4000; ++n) {
    const double x = n < 2000 ? 0.0 : 2e-6 * (n - 2000);
    const Vec3 tool = coupling.tool({x, -0.004, 0.0}, kTick, limits);
    const Vec3 before = force;
    force = coupling.feel(wall(tool, 1000.0, 0.2), limits);
    EXPECT_LE(std::fabs(force.x), 0.2 + 1e-12);
    if (n > 2000) {
      EXPECT_LT(length(force - before), 200.0 * 2e-6 * 1.01);
    }
    if (n == 2250) {
      EXPECT_NEAR(force.x, -200.0 * 2e-6 * 250.0, 1e-6) << "it sticks";
    }
  }
  EXPECT_NEAR(force.x, -0.2, 1e-9) << "it slides";
}

TEST(Coupling, AnEncoderThatFlickersAtRestIsFeltByItsStepAlone) {
  Coupling coupling;
  const CouplingLimits limits{300.0, 3.3};
  Vec3 force;
  for (int n = 0; n < 2000; ++n) {
    const double flicker = n % 2 == 0 ? 0.0 : 5.5e-5;
    const Vec3 tool = coupling.tool({flicker, -0.004 + flicker, 0.0}, kTick, limits);
    const Vec3 before = force;
    force = coupling.feel(wall(tool, 1500.0, 0.3), limits);
    if (n > 100) {
      EXPECT_LT(length(force - before), 300.0 * 5.5e-5 * 1.5);
    }
  }
}

TEST(Coupling, ClayThatTurnsCarriesTheToolAsFarAsItsGripAndNoFarther) {
  Coupling coupling;
  const CouplingLimits limits{100.0, 3.3};
  Vec3 tool;
  for (int n = 0; n < 1000; ++n) {
    tool = coupling.tool({0.0, -0.005, 0.0}, kTick, limits);
    coupling.feel(wall(tool, 1000.0, 0.15, {0.6, 0.0, 0.0}), limits);
  }
  EXPECT_NEAR(tool.x, 0.15 / 100.0, 1e-9);
  EXPECT_EQ(tool.z, 0.0);
}

TEST(Coupling, AToolThatNothingHoldsAnyMoreComesBackWithoutALeap) {
  Coupling coupling;
  const CouplingLimits limits{20.0, 3.3};
  Vec3 tool;
  for (int n = 0; n < 1000; ++n) {
    tool = coupling.tool({0.0, -0.04, 0.0}, kTick, limits);
    coupling.feel(wall(tool, 3000.0), limits);
  }
  EXPECT_GT(tool.y, -0.001);
  double last = tool.y;
  for (int n = 0; n < 100; ++n) {
    coupling.feel({}, limits);
    tool = coupling.tool({0.0, -0.04, 0.0}, kTick, limits);
    EXPECT_LE(std::fabs(tool.y - last), Coupling::kReturn * kTick * 1.0001);
    last = tool.y;
  }
  EXPECT_NEAR(tool.y, -0.04, 1e-6);
}

TEST(Coupling, AToolThatTremblesIsFeltByTheMeanOfThreeTicks) {
  // A wall that pushes 0.3 N and trembles by a twentieth three ticks long: the hand feels a
  // five hundredth of that.
  for (const double seconds : {0.001, 0.0005}) {
    Coupling coupling;
    const CouplingLimits limits{200.0, 3.3};
    const int period = static_cast<int>(0.003 / seconds + 0.5);
    double least = 1e9, most = 0.0, reach = 0.0;
    for (int n = 0; n < 3000; ++n) {
      coupling.tool({}, seconds, limits);
      const double tremble = n % period == 0 ? 1.05 : 1.0;
      const Vec3 force = coupling.feel({{0.3 * tremble, 0.0, 0.0}, 600.0, 0.0, 0.0, {}}, limits);
      if (n < 2000) continue;
      least = std::min(least, force.x);
      most = std::max(most, force.x);
      reach = std::max(reach, std::fabs(200.0 * coupling.stretch().x - force.x));
    }
    EXPECT_LT(most - least, 3e-5) << seconds;
    EXPECT_GT(reach, 1e-3) << "the tool itself trembles";
  }
}

TEST(Coupling, LearnsThatATurningWheelBringsFreshClay) {
  // The push is told to fade within 10 ms and never does, as of clay that comes anew: the force is
  // the push itself, not a twentieth less.
  Coupling coupling;
  const CouplingLimits limits{257.0, 3.3};
  double depth = 0.001;  // m, of the tool in clay of 600 N/m
  Vec3 force;
  for (int n = 0; n < 500; ++n) {
    const double out = coupling.tool({}, kTick, limits).x;
    depth = 0.001 - out;
    force = coupling.feel({{600.0 * depth, 0.0, 0.0}, 600.0, 0.01, 0.0, {}}, limits);
  }
  EXPECT_NEAR(force.x / (600.0 * depth), 1.0, 1e-3);
  EXPECT_NEAR(force.x, 1e-3 * 600.0 * 257.0 / 857.0, 1e-3);
}

TEST(Coupling, HasLearntTwoThirdsOfItWithinTenMilliseconds) {
  // The same, and how much less than the push is felt: from the first touch on it fades by 1 / e in
  // the time that learning takes.
  for (const double tick : {0.0005, 0.001}) {
    Coupling coupling;
    const CouplingLimits limits{257.0, 3.3};
    double short_by = 0.0, first = 0.0, seconds = 0.0;
    for (int n = 0; n < 1000; ++n) {
      const double depth = 0.001 - coupling.tool({}, tick, limits).x;
      const double force =
          coupling.feel({{600.0 * depth, 0.0, 0.0}, 600.0, 0.1, 0.0, {}}, limits).x;
      short_by = 1.0 - force / (600.0 * depth);
      if (n == 20) first = short_by;
      if (n > 20 && short_by < first / 2.71828 && seconds == 0.0) seconds = (n - 20) * tick;
    }
    EXPECT_GT(first, 1e-4) << "there is something to learn";
    EXPECT_NEAR(seconds, 0.01, 0.002) << tick;
  }
}

TEST(Coupling, IsNeverStretchedBeyondTheGreatestForce) {
  for (const double most : {0.0, 1.0, 22.2}) {
    Coupling coupling;
    const CouplingLimits limits{30.0, most};
    Vec3 force;
    for (int n = 0; n < 3000; ++n) {
      const Vec3 tool = coupling.tool({0.0, -1e-3 * n, 0.0}, kTick, limits);
      force = coupling.feel(wall(tool, 5000.0), limits);
      EXPECT_LE(length(force), most * (1.0 + 1e-12));
    }
    EXPECT_NEAR(force.y, most, 1e-9);
  }
}

TEST(Coupling, ATouchThatIsNoNumberLetsGo) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Touch& bad : {Touch{{nan, 0, 0}, 1.0, 0.0, 0.0, {}}, Touch{{}, nan, 0.0, 0.0, {}},
                           Touch{{}, 0.0, nan, 0.0, {}}, Touch{{}, 0.0, 0.0, nan, {}},
                           Touch{{}, 0.0, 0.0, 0.0, {0, nan, 0}}}) {
    Coupling coupling;
    const CouplingLimits limits{100.0, 3.3};
    for (int n = 0; n < 50; ++n) {
      const Vec3 tool = coupling.tool({0.0, -0.002, 0.0}, kTick, limits);
      coupling.feel(wall(tool, 1000.0), limits);
    }
    EXPECT_EQ(coupling.feel(bad, limits), Vec3{});
    EXPECT_EQ(coupling.tool({0.0, -0.002, 0.0}, kTick, limits), (Vec3{0.0, -0.002, 0.0}));
  }
}

}  // namespace
}  // namespace onggi::force::coupling_test
