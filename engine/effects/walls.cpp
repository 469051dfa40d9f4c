#include "engine/effects/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/math/portable.h"

namespace onggi {

namespace {

constexpr double kBeside = 0.008;   // m: about as far as a finger bends a wall sideways
constexpr double kSampled = 0.002;  // m: what is finer is not looked at row by row

// 0 below 0, 1 above 1, zero slope at both.
double smooth_step(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// Every how many rows or sectors of `size` (m) one is looked at.
int every(double size) { return std::max(static_cast<int>(kSampled / size), 1); }

// A weight, and how it grows as the patch moves towards it by its own half width. Also sums of
// such weights.
struct Weight {
  double is = 0.0, grows = 0.0;

  void add(const Weight& weight, double value) {
    is += weight.is * value;
    grows += weight.grows * value;
  }
};
Weight weight_at(double off) {
  const double t = std::max((1.0 - off) * (1.0 + off), 0.0);
  return {t * t, 4.0 * off * t};
}

// A height that follows `height` to `top` (m) and stays there; it begins to stop a little below, so
// that nothing that depends on it has a bend.
struct BelowTop {
  double height, follows;  // `follows`: 1 to 0
};
BelowTop below_top(double height, double top) {
  constexpr double kSoft = 0.002;  // m
  const double over = std::clamp(height - top + kSoft, 0.0, 2.0 * kSoft);
  return {std::min(height, top + kSoft) - over * over / (4.0 * kSoft), 1.0 - over / (2.0 * kSoft)};
}

// Gauss-Legendre nodes and weights on 0..1.
struct Node {
  double at, weight;
};
constexpr std::array<Node, 5> kNodes{{{0.046910077030668, 0.118463442528095},
                                      {0.230765344947158, 0.239314335249683},
                                      {0.5, 0.284444444444444},
                                      {0.769234655052842, 0.239314335249683},
                                      {0.953089922969332, 0.118463442528095}}};

}  // namespace

std::span<const DefField<WallsDef>> WallsDef::fields() {
  static constexpr DefField<WallsDef> kFields[] = {
      {"support", &WallsDef::support, 0.001, 0.2, "m"},
      {"tear_thickness", &WallsDef::tear_thickness, 0.0, 0.02, "m"},
      {"tear_strain", &WallsDef::tear_strain, 0.0, 10.0, ""},
      {"bending_strength", &WallsDef::bending_strength, 0.0, 1e6, "Pa", "yield_stress"},
  };
  return kFields;
}

namespace effects {

double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept {
  // Distance along the wall: up, and round it at the pressing hand's radius.
  const double radius = axis_distance(pressing);
  const double inward = axis_distance(holding);
  const double both = std::max(radius * inward, 1e-12);
  const double cosine = (pressing.x * holding.x + pressing.z * holding.z) / both;
  // The chord of the angle between them. It needs no arc cosine, and the far side counts as far.
  const double chord = radius * std::sqrt(std::max(2.0 - 2.0 * cosine, 0.0));
  const double up = pressing.y - holding.y;
  const double apart = std::sqrt(up * up + chord * chord) / def.support;
  return smooth_step(1.0 - apart);
}

double wall_bears(const WallsDef& def, double thickness, double strength) noexcept {
  return portable::kPi * strength * def.bending_strength * thickness * thickness;
}

double wall_push(double normal, double bears, double held) noexcept {
  const double alone = normal - held;
  if (!(bears > 0.0)) return held;
  const double over = alone / bears;
  return held + alone / std::sqrt(1.0 + over * over);
}

ClearOfFoot clear_of_foot(const Clay& clay, double height) noexcept {
  const double t = std::clamp((height - clay.floor_top()) / kBeside, 0.0, 1.0);
  return {smooth_step(t), 6.0 * t * (1.0 - t) / kBeside};
}

WallBehind wall_behind(const Clay& clay, const Moisture* moisture, Vec3 at) noexcept {
  // Of a coarse grid a wider patch is needed. Rows may become twice as thick as they were.
  const int row_step = every(clay.first_thickness());
  const double up_to = std::max(kBeside, 3.0 * row_step * clay.first_thickness());
  const double element = 2.0 * portable::kPi / clay.sectors();
  const int column_step = every(clay.def().outer_radius * element);
  // At most once round the ring.
  const double radius = std::max(axis_distance(at), kBeside / portable::kPi);
  const double round =
      std::clamp(kBeside / (radius * element), 1.5 * column_step, 0.5 * clay.sectors());

  const BelowTop y = below_top(at.y, clay.row_height(clay.rows() - 1));
  struct Row {
    const float *outer, *inner;
    Weight weight;
  };
  std::array<Row, 128> rows;
  std::size_t used = 0;
  Weight row_sum, wet;
  const auto add = [&](int j, const Weight& weight) {
    rows[used++] = {clay.outer(j).data(), clay.inner(j).data(), weight};
    row_sum.add(weight, 1.0);
    if (moisture != nullptr) wet.add(weight, moisture->of_row(clay.stored(j)));
  };
  const int lowest = std::max(clay.first_row_above(y.height - up_to), clay.floor_rows());
  for (int j = (lowest + row_step - 1) / row_step * row_step;
       j < clay.rows() && used < rows.size() && clay.row_height(j) < y.height + up_to;
       j += row_step)
    add(j, weight_at((clay.row_height(j) - y.height) / up_to));
  if (used == 0) add(clay.rows() - 1, {1.0, 0.0});  // a wall of a millimetre or two

  double turn = portable::atan2(at.z, at.x);
  if (turn < 0.0) turn += 2.0 * portable::kPi;
  const double middle = turn / element - 0.5 + clay.sectors();  // in elements
  const auto first = static_cast<int>(std::ceil((middle - round) / column_step));
  Weight column_sum;
  double sum = 0.0, rising = 0.0, turning = 0.0;
  for (int k = first * column_step; k < middle + round; k += column_step) {
    const auto i = static_cast<std::size_t>(k % clay.sectors());
    const Weight weight = weight_at((k - middle) / round);
    Weight column;
    for (const Row& row : std::span(rows).first(used))
      column.add(row.weight, double{row.outer[i]} - double{row.inner[i]});
    column_sum.add(weight, 1.0);
    sum += weight.is * column.is;
    rising += weight.is * column.grows;
    turning += weight.grows * column.is;
  }
  WallBehind out;
  const double all = row_sum.is * column_sum.is;
  out.thickness = sum / all;
  out.wetness = wet.is / row_sum.is;
  const double up = y.follows / up_to;
  out.thicker.y = up * (rising / all - out.thickness * row_sum.grows / row_sum.is);
  out.wetter.y = up * (wet.grows - out.wetness * row_sum.grows) / row_sum.is;
  const double on = (turning / all - out.thickness * column_sum.grows / column_sum.is) /
                    (round * element * radius);
  out.thicker.x = -portable::sin(turn) * on;
  out.thicker.z = portable::cos(turn) * on;
  return out;
}

BendSlopes bend_slopes(double alone, double clear, double bears, double depth,
                       double radius) noexcept {
  BendSlopes out;
  if (!(bears > 0.0)) return out;
  const bool round = radius > 0.0;
  const double deep = round ? std::min(depth / radius, 1.0) : 0.0;
  for (const Node& node : kNodes) {
    // The sum of a ball's normal forces at a depth l: l^2 (3 R - l). Of them its push is the share
    // (6 R^2 - 4 l R + l^2) / (6 R^2 - 2 l R). Of an edge or a plate on a round wall: l^1.5.
    const double there = deep * node.at;
    const double grown =
        round ? node.at * node.at * (3.0 - there) / (3.0 - deep) : node.at * std::sqrt(node.at);
    const double push = alone * grown;
    const double weight = node.weight * (6.0 - 4.0 * there + there * there) / (6.0 - 2.0 * there);
    const double over = clear * push / bears;
    const double less = 1.0 / std::sqrt(1.0 + over * over);
    const double cube = less * less * less;
    out.by_clear += weight * push * (1.0 - cube);
    out.by_bears -= weight * over * over * over * cube;
  }
  out.by_clear *= depth;
  out.by_bears *= depth;
  return out;
}

}  // namespace effects
}  // namespace onggi
