#include "engine/math/portable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "engine/math/hash.h"
#include "engine/math/random.h"

namespace onggi::portable_test {
namespace {

// Largest relative distance of `ours` from libm's `theirs` over 200,000 points of `draw`.
template <class Ours, class Theirs, class Draw>
double worst(Ours ours, Theirs theirs, Draw draw) {
  Random random(7);
  double most = 0.0;
  for (int n = 0; n < 200000; ++n) {
    const double x = draw(random);
    const double expected = theirs(x);
    const double distance = std::fabs(ours(x) - expected);
    most = std::max(most, distance / std::max(std::fabs(expected), 1e-300));
  }
  return most;
}

TEST(Portable, SineAndCosineAgreeWithTheMathLibraryTo1e15) {
  const auto turn = [](Random& r) { return r.uniform(-10.0, 10.0); };
  const auto far = [](Random& r) { return r.uniform(-1e6, 1e6); };
  EXPECT_LT(
      worst([](double x) { return portable::sin(x); }, [](double x) { return std::sin(x); }, turn),
      1e-15);
  EXPECT_LT(
      worst([](double x) { return portable::cos(x); }, [](double x) { return std::cos(x); }, turn),
      1e-15);
  EXPECT_LT(
      worst([](double x) { return portable::sin(x); }, [](double x) { return std::sin(x); }, far),
      1e-15);
  EXPECT_LT(
      worst([](double x) { return portable::cos(x); }, [](double x) { return std::cos(x); }, far),
      1e-15);
}

TEST(Portable, ExponentialsAndLogarithmAgreeWithTheMathLibraryTo1e15) {
  const auto wide = [](Random& r) { return r.uniform(-700.0, 700.0); };
  const auto small = [](Random& r) {
    return r.uniform(-1.0, 1.0) * std::ldexp(1.0, -static_cast<int>(r.bits() % 60));
  };
  const auto positive = [](Random& r) {
    return std::ldexp(r.uniform(0.5, 1.0), static_cast<int>(r.bits() % 200) - 100);
  };
  EXPECT_LT(
      worst([](double x) { return portable::exp(x); }, [](double x) { return std::exp(x); }, wide),
      1e-15);
  EXPECT_LT(worst([](double x) { return portable::expm1(x); },
                  [](double x) { return std::expm1(x); }, wide),
            1e-15);
  EXPECT_LT(worst([](double x) { return portable::expm1(x); },
                  [](double x) { return std::expm1(x); }, small),
            1e-15);
  EXPECT_LT(worst([](double x) { return portable::log(x); }, [](double x) { return std::log(x); },
                  positive),
            1e-15);
  EXPECT_LT(worst([](double x) { return portable::log(1.0 + x); },
                  [](double x) { return std::log(1.0 + x); }, small),
            1e-15);
}

TEST(Portable, AnglesAgreeWithTheMathLibraryTo1e15) {
  const auto unit = [](Random& r) { return r.uniform(-1.0, 1.0); };
  EXPECT_LT(worst([](double x) { return portable::asin(x); }, [](double x) { return std::asin(x); },
                  unit),
            1e-15);
  Random random(3);
  for (int n = 0; n < 200000; ++n) {
    const double y = random.uniform(-1.0, 1.0);
    const double x = random.uniform(-1.0, 1.0);
    const double expected = std::atan2(y, x);
    ASSERT_LE(std::fabs(portable::atan2(y, x) - expected), 1e-15 * std::fabs(expected))
        << y << " " << x;
  }
}

TEST(Portable, EdgesAreDefined) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(portable::sin(0.0), 0.0);
  EXPECT_EQ(portable::cos(0.0), 1.0);
  EXPECT_TRUE(std::isnan(portable::sin(inf)));
  EXPECT_TRUE(std::isfinite(portable::sin(1e300)));
  EXPECT_EQ(portable::exp(0.0), 1.0);
  EXPECT_EQ(portable::exp(-1e9), 0.0);
  EXPECT_EQ(portable::exp(1e9), inf);
  EXPECT_EQ(portable::expm1(-1e9), -1.0);
  EXPECT_EQ(portable::log(1.0), 0.0);
  EXPECT_EQ(portable::log(0.0), -inf);
  EXPECT_TRUE(std::isnan(portable::log(-1.0)));
  EXPECT_TRUE(std::isnan(portable::exp(nan)));
  EXPECT_TRUE(std::isnan(portable::asin(1.0000001)));
  EXPECT_EQ(portable::asin(1.0), 0.5 * portable::kPi);
  EXPECT_EQ(portable::atan2(0.0, 0.0), 0.0);
  EXPECT_EQ(portable::atan2(0.0, -1.0), portable::kPi);
  EXPECT_EQ(portable::atan2(-1.0, 0.0), -0.5 * portable::kPi);
  EXPECT_EQ(portable::exp(-745.0), std::exp(-745.0));  // subnormal
}

TEST(Portable, BitsAreTheSameOnEveryMachineAndCompiler) {
  Random random(11);
  StateHash hash;
  for (int n = 0; n < 10000; ++n) {
    const double x = random.uniform(-20.0, 20.0);
    const double y = random.uniform(-1.0, 1.0);
    for (double v : {portable::sin(x), portable::cos(x), portable::exp(x), portable::expm1(y),
                     portable::log(y + 1.5), portable::asin(y), portable::atan2(y, x)})
      hash.add(v);
  }
  EXPECT_EQ(hash.value(), 0xb4a3743fce2cbf11ULL);
}

}  // namespace
}  // namespace onggi::portable_test
