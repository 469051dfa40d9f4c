#include "engine/force/passivity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace onggi::force::passivity_test {
namespace {

constexpr double kTick = 0.001;

/// A bare handle of 45 g at a sampled spring of `stiffness` N/m, let go of 2 mm from rest. How far
/// it swings after `seconds`, as a share of that.
double swing(double stiffness, const PassivityLimits& limits, double seconds) {
  PassivityControl control;
  constexpr int kParts = 20;
  double at = 0.002, speed = 0.0, widest = 0.0;
  const int ticks = static_cast<int>(seconds / kTick);
  for (int n = 0; n < ticks; ++n) {
    const Vec3 force = control.step({at, 0, 0}, {-stiffness * at, 0, 0},
                                    {{-stiffness * at, 0, 0}, 0, 0, 0, {}}, kTick, limits);
    for (int part = 0; part < kParts; ++part) {
      speed += force.x / 0.045 * kTick / kParts;
      at += speed * kTick / kParts;
    }
    if (n > ticks - 200) widest = std::max(widest, std::fabs(at));
    if (!(std::fabs(at) < 10.0)) return 1e9;
  }
  return widest / 0.002;
}

TEST(Passivity, ASampledSpringThatGivesMoreThanItTookIsBroughtToRest) {
  // Without damping of its own no sampled spring is passive.
  for (const double stiffness : {50.0, 500.0}) {
    EXPECT_GT(swing(stiffness, {stiffness, 0.0, 0.0, 0}, 4.0), 1.5) << stiffness;
    EXPECT_LT(swing(stiffness, {stiffness, 0.0, 4.0, 0}, 4.0), 1.05) << stiffness;
  }
}

TEST(Passivity, AHandThatTheWheelDragsAlongIsNotBlamed) {
  // Clay goes by at 0.5 m/s and drags a hand with 0.3 N, which lets itself be dragged by 0.1 m/s.
  const auto most = [](Vec3 clay) {
    PassivityControl control;
    const PassivityLimits limits{200.0, 0.0, 4.0, 0};
    double damping = 0.0;
    for (int n = 0; n < 2000; ++n) {
      control.step({1e-4 * n, 0, 0}, {0.3, 0, 0}, {{0, 1, 0}, 1000.0, 0.0, 0.3, clay}, kTick,
                   limits);
      damping = std::max(damping, control.damping());
    }
    return damping;
  };
  EXPECT_EQ(most({0.5, 0, 0}), 0.0);
  EXPECT_LT(most({0.1, 0, 0}), 1e-9) << "it goes along: the wheel does all of it";
  EXPECT_GT(most({0.0, 0, 0}), 0.5) << "nobody's work is blamed";
}

TEST(Passivity, AWheelThatStandsGivesNoCredit) {
  PassivityControl control;
  for (int n = 0; n < 5000; ++n)
    control.step({}, {0.5, 0, 0}, {{0.5, 0, 0}, 1000.0, 0.0, 0.3, {0.5, 0, 0}}, kTick,
                 {200.0, 0.5, 4.0, 0});
  // What coupling and clay can hold at 0.5 N, and not what the wheel ground away in 5 s.
  EXPECT_NEAR(control.energy(), 0.5 * 0.25 * (1.0 / 200.0 + 1.0 / 1000.0), 1e-9);
}

TEST(Passivity, AddsNoMoreDampingThanItMayAndNoneWhereItMayNot) {
  for (const double most : {0.0, 2.0}) {
    PassivityControl control;
    for (int n = 0; n < 500; ++n) {
      const Vec3 out =
          control.step({1e-4 * n, 0, 0}, {1.0, 0, 0}, {}, kTick, {100.0, 0.0, most, 0});
      EXPECT_LE(control.damping(), most);
      EXPECT_LE(std::fabs(out.x - 1.0), most * 0.1 * 1.001);
    }
    EXPECT_EQ(control.damping(), most);
  }
}

TEST(Passivity, AnOldDebtIsNotPaidForEver) {
  PassivityControl control;
  const PassivityLimits limits{100.0, 0.0, 2.0, 0};
  for (int n = 0; n < 5000; ++n) control.step({1e-4 * n, 0, 0}, {3, 0, 0}, {}, kTick, limits);
  EXPECT_EQ(control.energy(), -PassivityControl::kMostDebt);
  // 0.1 m/s against 1 N pays 0.1 W.
  int ticks = 0;
  for (; control.energy() < 0.0 && ticks < 1000; ++ticks)
    control.step({0.5 - 1e-4 * ticks, 0, 0}, {1, 0, 0}, {}, kTick, limits);
  EXPECT_LT(ticks, 50);
}

TEST(Passivity, AForceThatIsLaterThanEightTicksCountsAsThatLate) {
  const auto ledger = [](int delay) {
    PassivityControl control;
    for (int n = 0; n < 100; ++n)
      control.step({1e-5 * (n % 11), 0, 0}, {0.01 * (n % 13), 0, 0}, {}, kTick,
                   {1.0, 0.0, 0.0, delay});
    return control.energy();
  };
  EXPECT_EQ(ledger(8), ledger(30));
  EXPECT_NE(ledger(7), ledger(8));
  EXPECT_LT(std::fabs(ledger(8)), 0.9 * PassivityControl::kMostDebt) << "it is not full";
}

TEST(Passivity, TheLedgerKnowsThatAForceIsFeltLate) {
  for (const int delay : {0, 3, PassivityControl::kMostDelay}) {
    PassivityControl control;
    // Forces that come in pulses, each felt `delay` ticks later: the hand moves only then.
    double x = 0.0, by_hand = 0.0;
    Vec3 wire[PassivityControl::kMostDelay + 1]{};
    for (int n = 0; n < 60; ++n) {
      const Vec3 out = control.step({x, 0, 0}, {n % 7 == 0 ? -1.0 : -0.2, 0, 0},
                                    {{-1, 0, 0}, 0, 0, 0, {}}, kTick, {1.0, 0.0, 0.0, delay});
      wire[n % (PassivityControl::kMostDelay + 1)] = out;
      const int from = n - delay;
      const Vec3 felt = from < 0 ? Vec3{} : wire[from % (PassivityControl::kMostDelay + 1)];
      if (n == 59) break;
      x += 1e-5;
      by_hand -= felt.x * 1e-5;
    }
    EXPECT_NEAR(control.energy(), by_hand, 1e-15) << delay;
  }
}

TEST(Passivity, BeforeTheFirstStepThereIsNoEnergyAndNothingIsAdded) {
  const PassivityControl fresh;
  EXPECT_EQ(fresh.energy(), 0.0);
  EXPECT_EQ(fresh.damping(), 0.0);
}

}  // namespace
}  // namespace onggi::force::passivity_test
