#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/effects/smoothing.h"
#include "tests/engine/effects/random_hands.h"
#include "tests/engine/effects/witnessed.h"

namespace onggi::effects::smoothing_witness_test {
namespace {

using namespace effects_test;

// Written from the equation in engine/docs/effects.md alone: d(R^2)/dt = pace d2(R^2)/dz2, and no
// flow through the ends of the tool.

constexpr int kRows = 200;
constexpr double kRow = 0.001;  // m
constexpr int kLow = 50, kHigh = 150;

// One step of the implicit rule in doubles: Thomas' algorithm.
void diffuse(std::vector<double>& q, double pace, double seconds) {
  const std::size_t n = q.size();
  const double f = pace * seconds / (kRow * kRow);
  std::vector<double> up(n), value(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double below = k > 0 ? f : 0.0;
    const double above = k + 1 < n ? f : 0.0;
    const double pivot = 1.0 + below + above - (k > 0 ? below * up[k - 1] : 0.0);
    up[k] = above / pivot;
    value[k] = (q[k] + (k > 0 ? below * value[k - 1] : 0.0)) / pivot;
  }
  for (std::size_t k = n; k-- > 0;) q[k] = value[k] + (k + 1 < n ? up[k] * q[k + 1] : 0.0);
}

Clay lined(double depth, bool inside) {
  ClayDef def;
  def.rows = kRows;
  def.sectors = 24;
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  clay.keep_areas();
  clay.keep_displacements();
  for (int j = 0; j < clay.rows(); ++j) {
    const double line = depth * std::sin(2.0 * 3.14159265358979 * clay.row_height(j) / 0.01);
    for (float& r : inside ? clay.inner_mut(j) : clay.outer_mut(j))
      r = static_cast<float>((inside ? 0.024 : 0.053) + line);
    clay.areas()->set(j, clay.measured_area(j));
  }
  return clay;
}

// How much of the lines' height is wrong after a rib lay there for `seconds`, as a share of what
// they lost by the equation.
double off(double depth, double pace, double tick, double seconds, bool inside) {
  Clay clay = lined(depth, inside);
  const auto radius = [&](int j) { return double{inside ? clay.inner(j)[5] : clay.outer(j)[5]}; };
  std::vector<double> q;
  for (int j = kLow; j < kHigh; ++j) q.push_back(radius(j) * radius(j));
  const std::vector<double> before = q;
  SmoothingDef def;
  def.pace = pace;
  const WallSide side = inside ? WallSide::inside : WallSide::outside;
  const int ticks = static_cast<int>(std::lround(seconds / tick));
  for (int n = 0; n < ticks; ++n) {
    for (int j = 0; j < kRows; ++j) {
      clay.displacements(inside)->mark(j, {0, 3});
      std::fill_n(clay.displacements(inside)->row(clay.stored(j)), clay.sectors(), 1e-6f);
    }
    Smoothing smoothing(clay.rows());
    smoothing.even(def, clay, side, kLow * kRow, kHigh * kRow, tick);
    clay.displacements(inside)->clear(clay.stored());
    diffuse(q, pace, tick);
  }
  double faded = 0.0, wrong = 0.0;
  for (std::size_t k = 0; k < q.size(); ++k) {
    faded = std::max(faded, std::fabs(std::sqrt(q[k]) - std::sqrt(before[k])));
    wrong = std::max(wrong, std::fabs(radius(kLow + static_cast<int>(k)) - std::sqrt(q[k])));
  }
  constexpr double kDigit = 3.8e-9;  // of a float of 5 cm, m: more cannot be asked
  return std::max(wrong - kDigit, 0.0) / faded;
}

TEST(SmoothingWitness, LinesFadeByTheEquationHoweverShortTheTicksAndFineTheLines) {
  for (const bool inside : {false, true})
    for (const double depth : {1e-4, 1e-5, 1e-6})
      for (const double tick : {1e-5, 1e-4, 1e-3, 5e-3})
        for (const double pace : {1e-4, 1e-5}) {
          const double seconds = 0.005 * 1e-4 / pace;
          witnessed("smoothing",
                    "the implicit rule in doubles: lines of " + std::to_string(1e6 * depth) +
                        " um, pace " + std::to_string(1e6 * pace) + " mm^2/s, ticks of " +
                        std::to_string(1e3 * tick) + " ms" + (inside ? ", inside" : ""),
                    off(depth, pace, tick, seconds, inside), 2e-3);
        }
}

}  // namespace
}  // namespace onggi::effects::smoothing_witness_test
