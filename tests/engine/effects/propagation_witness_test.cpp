#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/effects/propagation.h"
#include "tests/engine/effects/random_hands.h"
#include "tests/engine/effects/witnessed.h"

namespace onggi::effects::propagation_witness_test {
namespace {

using namespace effects_test;

// Written from the equations in engine/docs/effects.md alone: share(z) = (e^(-z/reach) - e^-3) /
// (1 - e^-3) up to 3 reaches, and a row moves by the largest of every row's press x share.

double share(double apart, double reach) {
  const double end = std::exp(-3.0);
  return apart < 3.0 * reach ? (std::exp(-apart / reach) - end) / (1.0 - end) : 0.0;
}

std::vector<double> law(const Clay& clay, const std::vector<double>& press, double reach) {
  std::vector<double> moves(press.size());
  for (std::size_t j = 0; j < press.size(); ++j)
    for (std::size_t k = 0; k < press.size(); ++k) {
      const double apart =
          clay.row_height(static_cast<int>(j)) - clay.row_height(static_cast<int>(k));
      moves[j] = std::max(moves[j], press[k] * share(std::fabs(apart), reach));
    }
  return moves;
}

// How far the engine is off, as a share of the greatest press.
double off(const std::vector<double>& press, double reach, double height) {
  ClayDef def;
  def.rows = static_cast<int>(press.size());
  def.sectors = 16;
  def.height = height;
  def.floor_thickness = 0.0;
  Clay clay = std::move(*Clay::create(def));
  clay.keep_areas();
  clay.keep_displacements();
  for (int j = 0; j < clay.rows(); ++j) {
    const double by = press[static_cast<std::size_t>(j)];
    if (by <= 0.0) continue;
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      clay.outer_mut(j)[i] -= static_cast<float>(by);
      clay.displacements(false)->row(j)[i] = static_cast<float>(by);
    }
    clay.areas()->set(j, clay.measured_area(j));
    clay.displacements(false)->mark(j, {0, clay.stride() / Displacements::kBlock});
  }
  PropagationDef pull;
  pull.reach = reach;
  Propagation propagation(clay.rows());
  propagation.drag(pull, clay, WallSide::outside, 0.0);
  const std::vector<double> moves = law(clay, press, reach);
  const double most = *std::max_element(press.begin(), press.end());
  double wrong = 0.0;
  constexpr double kDigit = 8e-9;  // two of a float of 5 cm, m
  for (int j = 0; j < clay.rows(); ++j) {
    const double moved = def.outer_radius - double{clay.outer(j)[5]};
    wrong = std::max(wrong, std::fabs(moved - moves[static_cast<std::size_t>(j)]) - kDigit);
  }
  return std::max(wrong, 0.0) / most;
}

std::vector<double> ball(int rows, double height, double radius, double deep) {
  std::vector<double> press(static_cast<std::size_t>(rows));
  for (int j = 0; j < rows; ++j) {
    const double up = (j + 0.5) * height / rows - 0.5 * height;
    if (std::fabs(up) < radius)
      press[static_cast<std::size_t>(j)] =
          std::max(0.0, std::sqrt(radius * radius - up * up) - radius + deep);
  }
  return press;
}

// What is left out is said on the page: where the strongest pull ends, a nearer and weaker one that
// it covered does not take over.
TEST(PropagationWitness, ARowMovesByTheLargestOfEveryRowsPressTimesItsShareUnderABall) {
  for (const int rows : {100, 400, 3000})
    for (const double reach : {0.0005, 0.001, 0.003, 0.01})
      for (const double radius : {0.004, 0.008})
        for (const double deep : {1e-4, 1e-3})
          witnessed("propagation",
                    "every row's press x share: a ball of " + std::to_string(1e3 * radius) +
                        " mm, " + std::to_string(1e3 * deep) + " mm deep, reach " +
                        std::to_string(1e3 * reach) + " mm, " + std::to_string(rows) + " rows",
                    off(ball(rows, 0.1, radius, deep), reach, 0.1), 0.02);
}

}  // namespace
}  // namespace onggi::effects::propagation_witness_test
