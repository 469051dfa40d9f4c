#include "engine/force/decorating_tool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/force/haptics.h"
#include "engine/force/leather_hand.h"
#include "engine/math/random.h"

namespace onggi::force::decorating_tool_test {
namespace {

constexpr DecoratingLaw kLaws[] = {DecoratingLaw::cut, DecoratingLaw::scrape, DecoratingLaw::brush,
                                   DecoratingLaw::wipe, DecoratingLaw::stamp};
constexpr double kMs = 0.001;

/// Every law at both ends and the middle of every range.
std::vector<DecoratingTool> every_tool() {
  std::vector<DecoratingTool> tools;
  for (const DecoratingLaw law : kLaws)
    for (const double width : {2e-4, 0.008, 0.04})
      for (const double depth : {1.5e-4, 6e-4, 0.003})
        for (const double dryness : {0.0, 1.0})
          for (const double fill : {0.0, 0.5, 1.0})
            tools.push_back({law, width, depth, dryness, fill});
  return tools;
}

/// At the tool's own depth: what holds a hand that goes along the wall.
double drag(DecoratingTool tool) { return press_of(tool, tool.depth).grip; }

TEST(DecoratingTool, ANeedleALoopAndABrushHoldAHandAsHardAsWasAskedFor) {
  for (const double dryness : {0.0, 1.0}) {
    // A V of a needle, as ways have it.
    for (const auto& [width, depth] : {std::pair{8e-4, 4e-4}, {1e-3, 6e-4}, {1.2e-3, 7e-4}}) {
      const double needle = drag({DecoratingLaw::cut, width, depth, dryness, 0.5});
      EXPECT_GE(needle, 0.1) << width << ' ' << depth << ' ' << dryness;
      EXPECT_LE(needle, 0.6) << width << ' ' << depth << ' ' << dryness;
    }
    for (const double width : {0.006, 0.008, 0.012}) {
      const double loop = drag({DecoratingLaw::cut, width, 7e-4, dryness});
      EXPECT_GE(loop, 2.0) << width << ' ' << dryness;
      EXPECT_LE(loop, 8.0) << width << ' ' << dryness;
    }
    for (const double width : {0.004, 0.008, 0.03}) {
      const double brush = drag({DecoratingLaw::brush, width, 0.002, dryness});
      EXPECT_GE(brush, 0.02) << width;
      EXPECT_LE(brush, 0.3) << width;
    }
  }
  const double scraper = drag({DecoratingLaw::scrape, 0.02, 1.5e-4});
  EXPECT_GE(scraper, 2.0);
  EXPECT_LE(scraper, 8.0);
  const double brush = drag({DecoratingLaw::brush, 0.008, 0.002});
  for (const double middle :
       {drag({DecoratingLaw::wipe, 0.012, 0.0015}), drag({DecoratingLaw::stamp, 0.008, 6e-4})}) {
    EXPECT_GT(middle, brush);
    EXPECT_LT(middle, drag({DecoratingLaw::cut, 0.008, 7e-4}));
  }
}

TEST(DecoratingTool, WiderDeeperAndDrierHoldsHarder) {
  const DecoratingTool needle{DecoratingLaw::cut, 1e-3, 5e-4, 0.0, 0.5};
  for (double DecoratingTool::*more : {&DecoratingTool::width, &DecoratingTool::depth,
                                       &DecoratingTool::dryness, &DecoratingTool::fill}) {
    DecoratingTool other = needle;
    other.*more += 0.3 * (other.*more > 0.0 ? other.*more : 1.0);
    EXPECT_GT(drag(other), drag(needle));
  }
}

TEST(DecoratingTool, ThePushRisesWithTheDepthWithoutAStepAndNoQuickerThanItsStiffnessSays) {
  constexpr double kStep = 1e-6;
  for (const DecoratingTool& tool : every_tool()) {
    EXPECT_EQ(press_of(tool, 0.0).push, 0.0);
    EXPECT_EQ(press_of(tool, 0.0).grip, 0.0);
    EXPECT_EQ(press_of(tool, -0.001).push, 0.0);
    ToolPress before = press_of(tool, 0.0);
    for (double depth = kStep; depth < 0.005; depth += kStep) {
      const ToolPress now = press_of(tool, depth);
      ASSERT_GT(now.push, before.push) << depth;
      ASSERT_LE(now.push - before.push, kStep * now.stiffness * (1.0 + 1e-6) + 1e-15) << depth;
      ASSERT_GE(now.grip, before.grip) << depth;
      ASSERT_LE(now.grip, kMostGrip);
      ASSERT_LT(now.grip - before.grip, 0.07) << depth;
      before = now;
    }
  }
}

TEST(DecoratingTool, DeeperThanItsOwnDepthABladeCutsNoMore) {
  // What the edge's friction adds there is the push's.
  const DecoratingTool needle{DecoratingLaw::cut, 1e-3, 5e-4, 0.0, 0.5};
  const auto cuts = [&](double depth) {
    const ToolPress press = press_of(needle, depth);
    return press.grip - 0.4 * press.push;
  };
  EXPECT_NEAR(cuts(2.5e-4), 0.5 * cuts(5e-4), 1e-12);
  EXPECT_GT(cuts(5e-4), 0.05);
  EXPECT_NEAR(cuts(0.003), cuts(5e-4), 1e-12);
  EXPECT_GT(press_of(needle, 0.003).push, press_of(needle, 5e-4).push + 0.5) << "it stops there";
}

TEST(DecoratingTool, WhatIsOutOfItsRangeOrNoNumberCountsAsAnEnd) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const DecoratingTool least{DecoratingLaw::cut, 2e-4, 1.5e-4, 0.0, 0.0};
  const DecoratingTool most{DecoratingLaw::cut, 0.04, 0.003, 1.0, 1.0};
  for (const double depth : {1e-4, 1e-3, 5e-3}) {
    const double low = press_of(least, depth).grip, high = press_of(most, depth).grip;
    EXPECT_EQ(press_of({DecoratingLaw::cut, -1.0, -1.0, -1.0, -1.0}, depth).grip, low);
    EXPECT_EQ(press_of({DecoratingLaw::cut, kNone, kNone, kNone, kNone}, depth).grip, low);
    EXPECT_EQ(press_of({DecoratingLaw::cut, 9.0, 9.0, 9.0, 9.0}, depth).grip, high);
  }
  EXPECT_EQ(press_of(most, kNone).push, 0.0);
  EXPECT_EQ(press_of({}, 0.001).push, 0.0);
}

/// A cylinder of 60 mm radius, 150 mm high, with a lip of 6 mm.
LeatherOutline cylinder() {
  return LeatherOutline({{0.06, 0.0}, {0.06, 0.15}, {0.054, 0.15}, {0.054, 0.01}, {0.01, 0.01}});
}

// The hand does the work, and may get none that it did not do: over every closed path from clear to
// clear, whatever it does in between, through the coupling as a device has it.
TEST(DecoratingTool, NoClosedPathGivesAHandMoreThanItGave) {
  const LeatherOutline wall = cylinder();
  Random random(7);
  const auto between = [&random](double low, double high) {
    return low + (high - low) * random.uniform();
  };
  double lost = 0.0;
  for (const DecoratingTool& tool : every_tool()) {
    for (int path = 0; path < 4; ++path) {
      LeatherHand hand;
      Coupling coupling;
      const CouplingLimits limits{between(19.0, 500.0), 5.0};
      // Sums of sines with no offset at both ends: the path is closed.
      constexpr int kTicks = 1500;
      double size[3][3];
      int turns[3][3];
      for (auto& axis : size)
        for (double& one : axis) one = between(-0.003, 0.003);
      for (auto& axis : turns)
        for (int& one : axis) one = 1 + static_cast<int>(6.0 * random.uniform());
      const auto at = [&](int n) {
        double off[3] = {};
        for (int axis = 0; axis < 3; ++axis)
          for (int k = 0; k < 3; ++k)
            off[axis] +=
                size[axis][k] * std::sin(6.283185307179586 * turns[axis][k] * n / double{kTicks});
        return Vec3{0.0602 + off[0], 0.08 + 3.0 * off[1], 3.0 * off[2]};
      };
      double work = 0.0, most = 0.0;
      Vec3 was = at(0), force;
      for (int n = 0; n <= kTicks; ++n) {
        const Vec3 now = at(n);
        work -= dot(force, now - was);
        was = now;
        const Vec3 there = coupling.tool(now, kMs, limits);
        force = coupling.feel(hand.meet(wall, tool, there, 1.0, {}), limits);
        most = std::max(most, length(force));
      }
      ASSERT_LE(most, limits.max_force + 1e-9);
      // A sampled spring gives K times the square of a step at the most (Colgate): b > K T / 2.
      double steps = 0.0;
      for (int n = 0; n < kTicks; ++n) {
        const Vec3 step = at(n + 1) - at(n);
        steps += 0.5 * limits.stiffness * dot(step, step);
      }
      EXPECT_GE(work, -steps) << static_cast<int>(tool.law) << ' ' << tool.width << ' '
                              << tool.depth << ' ' << limits.stiffness;
      lost += work;
    }
  }
  EXPECT_GT(lost, 0.1) << "and most of them cost it something";
}

TEST(DecoratingTool, TheForceAgainstAHandPassesThroughRestWithoutAStep) {
  // To and fro by 8 mm along the wall, pushed into it by 3 mm: at each end the way turns round.
  const LeatherOutline wall = cylinder();
  for (const DecoratingLaw law : kLaws) {
    LeatherHand hand;
    Coupling coupling;
    const CouplingLimits limits{257.0, 5.0};
    double step = 0.0, most = 0.0;
    Vec3 was;
    for (int n = 0; n < 4000; ++n) {
      const double in = std::min(1.0, n / 500.0);
      const Vec3 at{0.061 - 0.003 * in, 0.08 + 0.008 * std::sin(0.0063 * n), 0.0};
      const Vec3 there = coupling.tool(at, kMs, limits);
      const Vec3 force = coupling.feel(hand.meet(wall, {law, 0.001, 5e-4}, there, 1.0, {}), limits);
      step = std::max(step, length(force - was));
      most = std::max(most, std::fabs(force.y));
      was = force;
    }
    EXPECT_LT(step, 0.03) << static_cast<int>(law);
    EXPECT_GT(most, 0.004) << static_cast<int>(law);
  }
}

}  // namespace
}  // namespace onggi::force::decorating_tool_test
