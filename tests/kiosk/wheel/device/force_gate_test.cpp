#include "kiosk/wheel/device/force_gate.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <limits>

namespace onggi::device::force_gate_test {
namespace {

constexpr ForceLimits kLimits{3.0, 600.0, 0.5};

/// A gate that is engaged and pushes with all it may.
ForceGate pushing() {
  ForceGate gate;
  LinkFault fault = LinkFault::none;
  for (int n = 0; n < 600; ++n) gate.step({}, 1e-3, kLimits, fault);
  for (int n = 0; n < 100; ++n) gate.step({9, 0, 0}, 1e-3, kLimits, fault);
  return gate;
}

TEST(ForceGate, EveryFaultIsZeroInTheVeryStepAndThenItEngagesFromNothing) {
  for (int f = 1; f < kLinkFaults; ++f) {
    ForceGate gate = pushing();
    ASSERT_DOUBLE_EQ(length(gate.force()), 3.0);
    auto fault = static_cast<LinkFault>(f);
    EXPECT_EQ(gate.step({9, 0, 0}, 1e-3, kLimits, fault), Vec3{}) << f;
    fault = LinkFault::none;
    // Still deep in the clay: nothing, until the wish has been small once.
    for (int n = 0; n < 1000; ++n) EXPECT_EQ(gate.step({9, 0, 0}, 1e-3, kLimits, fault), Vec3{});
    gate.step({0.1, 0, 0}, 1e-3, kLimits, fault);
    EXPECT_GT(length(gate.step({9, 0, 0}, 1e-3, kLimits, fault)), 0.0);
    EXPECT_LT(length(gate.force()), 0.02);
  }
}

TEST(ForceGate, AWishThatIsNoNumberIsAFaultOfItsOwn) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    ForceGate gate = pushing();
    LinkFault fault = LinkFault::none;
    EXPECT_EQ(gate.step({0, bad, 0}, 1e-3, kLimits, fault), Vec3{});
    EXPECT_EQ(fault, LinkFault::not_a_number);
  }
}

TEST(ForceGate, WhateverIsWantedItStaysUnderCapAndSlewButForTheEnd) {
  EXPECT_TRUE(rc::check([] {
    ForceGate gate;
    Vec3 before;
    for (int n = 0; n < 60; ++n) {
      const ForceLimits limits{0.001 * *rc::gen::inRange(0, 8000), 600.0, 0.05};
      const Vec3 wanted{*rc::gen::inRange(-100, 100) * 0.1, *rc::gen::inRange(-100, 100) * 0.1, 0};
      const double seconds = 1e-4 * *rc::gen::inRange(-5, 300);
      auto fault = *rc::gen::inRange(0, 12) == 0 ? LinkFault::stall : LinkFault::none;
      const Vec3 sent = whole_millinewtons(gate.step(wanted, seconds, limits, fault));
      RC_ASSERT(length(sent) <= limits.cap + 1e-12);
      // A pause is no licence to leap: 5 ms of change at the most. A smaller cap holds at once.
      const double most = limits.slew * std::min(std::max(seconds, 0.0), 0.005) + 2e-3;
      RC_ASSERT(sent == Vec3{} || length(sent - before) <= most ||
                length(sent) >= limits.cap - 2e-3);
      before = sent;
    }
  }));
}

TEST(ForceGate, WholeMillinewtonsAreNeverLonger) {
  EXPECT_EQ(whole_millinewtons({0.0019, -0.0019, 2.9999}), (Vec3{0.001, -0.001, 2.999}));
}

}  // namespace
}  // namespace onggi::device::force_gate_test
