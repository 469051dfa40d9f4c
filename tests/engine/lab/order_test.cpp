#include "engine/lab/order.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace onggi::lab::order_test {
namespace {

RC_GTEST_PROP(Order, WhatFallsByAPowerOfTheStepHasThatOrderAndIsWithinItsUncertainty, ()) {
  const double p = 0.1 * *rc::gen::inRange(8, 40);
  const double limit = *rc::gen::inRange(1, 1000);
  const double c = 0.01 * *rc::gen::inRange(1, 100);
  const double ratio = *rc::gen::inRange(2, 5);
  const auto at = [&](double h) { return limit + c * std::pow(h, p); };
  const Order order = observed_order(at(1.0), at(1.0 / ratio), at(1.0 / ratio / ratio), ratio, p);
  RC_ASSERT(std::fabs(order.p - p) < 1e-3);
  RC_ASSERT(order.asymptotic);
  RC_ASSERT(order.uncertainty >= std::fabs(at(1.0 / ratio / ratio) - limit));
}

TEST(Order, WhatGrowsOrSwingsOrFallsByAnotherPowerIsNotAsymptotic) {
  EXPECT_FALSE(observed_order(1.0, 4.0, 16.0, 2.0, 2.0).asymptotic);
  EXPECT_NEAR(observed_order(1.0, 4.0, 16.0, 2.0, 2.0).p, -2.0, 1e-12);
  EXPECT_FALSE(observed_order(1.0, 1.1, 1.0, 2.0, 2.0).asymptotic);
  EXPECT_TRUE(std::isnan(observed_order(1.0, 1.1, 1.0, 2.0, 2.0).p));
  EXPECT_FALSE(observed_order(1.5, 1.25, 1.125, 2.0, 2.0).asymptotic);
  EXPECT_TRUE(observed_order(1.5, 1.25, 1.125, 2.0, 1.0).asymptotic);
}

}  // namespace
}  // namespace onggi::lab::order_test
