#include "engine/surface/levelling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "engine/math/portable.h"

namespace onggi::surface::levelling_test {
namespace {

double kept(const LevelKernel& kernel, double phase) {
  double sum = static_cast<double>(kernel.weights[0]);
  for (int m = 1; m <= kernel.reach(); ++m)
    sum += 2.0 * static_cast<double>(kernel.weights[static_cast<std::size_t>(m)]) *
           portable::cos(phase * m);
  return sum;
}

TEST(Levelling, AWaveKeepsWhatTheLawSays) {
  for (const double b : {1.0 / 16, 1.0, 30.0, 1000.0, 1e5})
    for (double lengths = 0.0; lengths < 2.0; lengths += 0.1) {
      const double phase = lengths / std::sqrt(std::sqrt(b));
      if (phase > portable::kPi) continue;
      EXPECT_NEAR(kept(level_kernel(b), phase), std::exp(-b * std::pow(phase, 4)), 0.005)
          << b << ' ' << phase;
    }
}

TEST(Levelling, ALineThatHardlyLevelsIsLeftAsItIs) {
  EXPECT_TRUE(level_kernel(0.0).idle());
  EXPECT_TRUE(level_kernel(0.99 * kLeastLevelling).idle());
  EXPECT_TRUE(level_kernel(-1.0).idle());
  EXPECT_FALSE(level_kernel(kLeastLevelling).idle());
}

std::vector<float> hill(int count) {
  std::vector<float> line(static_cast<std::size_t>(count), 1.0f);
  line[3] = 9.0f;
  return line;
}

TEST(Levelling, ALineKeepsItsSumAndAnEvenOneItsHeight) {
  std::vector<float> room;
  const LevelKernel kernel = level_kernel(200.0);
  // Shorter than the kernel, too.
  for (const int count : {5, 20, 400}) {
    std::vector<const LevelKernel*> kernels(static_cast<std::size_t>(count), &kernel);
    std::vector<float> line = hill(count);
    level_line(line, kernels, room);
    EXPECT_NEAR(std::accumulate(line.begin(), line.end(), 0.0f), static_cast<float>(count) + 8.0f,
                1e-3f * static_cast<float>(count));
    EXPECT_LT(line[3], 5.0f);
    std::vector<float> even(static_cast<std::size_t>(count), 7.0f);
    level_line(even, kernels, room);
    for (const float value : even) EXPECT_NEAR(value, 7.0f, 1e-4f);
  }
}

TEST(Levelling, LanesAreLinesSideBySide) {
  std::vector<float> room;
  const LevelKernel wide = level_kernel(100.0), narrow = level_kernel(2.0), idle = level_kernel(0);
  std::vector<const LevelKernel*> kernels;
  for (int n = 0; n < 90; ++n) kernels.push_back(n % 5 == 0 ? &idle : n < 40 ? &wide : &narrow);
  std::vector<float> lanes(90 * kLanes);
  std::vector<std::vector<float>> lines(kLanes, std::vector<float>(90));
  for (std::size_t n = 0; n < lanes.size(); ++n)
    lines[n % kLanes][n / kLanes] = lanes[n] = static_cast<float>(n * 7919 % 101);
  level_lanes(lanes, kernels, room);
  for (std::vector<float>& line : lines) level_line(line, kernels, room);
  for (std::size_t n = 0; n < lanes.size(); ++n)
    ASSERT_EQ(lanes[n], lines[n % kLanes][n / kLanes]) << n;
}

TEST(Levelling, ARingHasNoSeam) {
  std::vector<float> room;
  const LevelKernel kernel = level_kernel(50.0);
  std::vector<float> here(100, 0.0f), there(100, 0.0f);
  here[50] = 1.0f, there[1] = 1.0f;
  level_ring(here, kernel, room);
  level_ring(there, kernel, room);
  for (std::size_t n = 0; n < 100; ++n) ASSERT_EQ(here[(n + 49) % 100], there[n]) << n;
}

}  // namespace
}  // namespace onggi::surface::levelling_test
