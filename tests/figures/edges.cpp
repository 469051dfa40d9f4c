// The data of the edge comparison of Lee & Choi 2009: the groove that a sphere leaves in a turning
// pot, and how sharp its edge is, with and without propagation. Equal bits on every machine. usage:
// onggi_figure_edges OUT.csv
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace {

namespace portable = onggi::portable;
using onggi::Clay;

constexpr double kTick = 0.001;     // s
constexpr double kSpeed = 0.001;    // m/s, towards the axis
constexpr double kWheel = 30.0;     // rad/s: five turns a millimetre
constexpr double kHeight = 0.036;   // m, half way up
constexpr double kSpan = 0.0005;    // m: a fingertip's ridge; an edge is judged over it
constexpr double kDeepest = 0.006;  // m
constexpr double kShown = 0.004;    // m: the outline that is drawn

// The pot of the paper's figures (config/scenes/paper.toml), with or without the effect.
onggi::SceneDef pot(bool propagates) {
  onggi::SceneDef def;
  onggi::each_effect(def, [](auto& effect) { effect.reset(); });
  def.clay.height = 0.072;
  def.clay.floor_thickness = 0.0;
  def.clay.wall_min = 0.0005;
  def.clay.inner_radius = def.clay.radius_min = 0.0001;
  def.clay.keep_undo = false;
  if (propagates) def.propagation.emplace();
  return def;
}

// The most that the outline turns from one kSpan to the next, degrees.
double sharpest(const Clay& clay) {
  const auto radius = [&](double height) {
    const int j = std::clamp(clay.first_row_above(height), 1, clay.rows() - 1);
    const double low = clay.row_height(j - 1);
    const double share = (height - low) / (clay.row_height(j) - low);
    return (1.0 - share) * double{clay.outer(j - 1)[0]} + share * double{clay.outer(j)[0]};
  };
  double most = 0.0;
  for (double y = 0.016; y < 0.056; y += 0.0001) {
    const double below = portable::atan2(radius(y) - radius(y - kSpan), kSpan);
    const double above = portable::atan2(radius(y + kSpan) - radius(y), kSpan);
    // An edge stands out of the clay: the outline turns towards the axis.
    most = std::max(most, below - above);
  }
  return most * 180.0 / portable::kPi;
}

bool draw(std::FILE* out, bool propagates) {
  auto scene = onggi::Scene::create(pot(propagates));
  if (!scene) return false;
  const char* name = propagates ? "with" : "without";
  const onggi::SceneDef& def = scene->def();
  const double surface = def.clay.outer_radius + def.tool.radius;
  const int ticks = static_cast<int>(std::lround(kDeepest / (kSpeed * kTick)));
  for (int n = 1; n <= ticks; ++n) {
    const double depth = kSpeed * kTick * n;
    onggi::Hands hands;
    hands.wheel_speed = kWheel;
    hands.hand[0] = {{surface - depth, kHeight, 0.0}, true, onggi::SideWish::outside};
    scene->step(hands, kTick);
    if (n % 200 == 0)
      std::fprintf(out, "edge,%s,%.3f,%.2f\n", name, 1e3 * depth, sharpest(scene->clay()));
    if (n != static_cast<int>(std::lround(kShown / (kSpeed * kTick)))) continue;
    for (int j = 0; j < scene->clay().rows(); ++j)
      std::fprintf(out, "outline,%s,%.4f,%.3f\n", name, 1e3 * double{scene->clay().outer(j)[0]},
                   1e3 * scene->clay().row_height(j));
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  std::FILE* out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_edges OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(out,
               "# A sphere of 8 mm pushed at 1 mm/s into a turning pot of 55 mm radius, 400 x 360"
               " elements.\n"
               "# outline: radius and height, mm, at 4 mm; edge: depth, mm, and the most that the"
               " outline turns in 0.5 mm, degrees.\n"
               "what,propagation,x,y\n");
  const bool good = draw(out, false) && draw(out, true);
  return std::fclose(out) == 0 && good ? 0 : 1;
}
