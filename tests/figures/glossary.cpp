// The data of the figure of engine/docs/glossary.md: a coarse pot that a ball presses from outside,
// cut level through the ball and upright along its ray. Equal bits on every machine.
// usage: onggi_figure_glossary OUT.csv
#include <algorithm>
#include <cstdio>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace {

namespace portable = onggi::portable;
using onggi::Clay;

constexpr double kBall = 0.010;  // m: radius
constexpr double kHeight = 0.05;
constexpr double kFrom = 0.0645, kTo = 0.0585;  // m from the axis: clear of the clay, and in it
constexpr int kTicks = 8;                       // after which the clay has given way by half
constexpr int kAround = 4;                      // points on an element's edge

std::FILE* out = nullptr;

void point(const char* part, double x, double y) {
  std::fprintf(out, "%s,%.4f,%.4f\n", part, 1e3 * x, 1e3 * y);
}
void end_line() { std::fprintf(out, "\n"); }

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// From ray to ray; element i spans [i, i + 1) sectors, and the ball is at the middle of element 0.
void arc(const Clay& clay, const char* part, int i, double radius, bool back) {
  const double sector = 2.0 * portable::kPi / clay.sectors();
  for (int k = 0; k <= kAround; ++k) {
    const double share = static_cast<double>(back ? kAround - k : k) / kAround;
    const double angle = (i - 0.5 + share) * sector;
    point(part, radius * portable::cos(angle), radius * portable::sin(angle));
  }
}

void element(const Clay& clay, const char* part, int j, int i) {
  const int n = (i + clay.sectors()) % clay.sectors();
  arc(clay, part, i, double{clay.outer(j)[at(n)]}, false);
  arc(clay, part, i, double{clay.inner(j)[at(n)]}, true);
  const double edge = (2 * i - 1) * portable::kPi / clay.sectors();
  const double outer = double{clay.outer(j)[at(n)]};
  point(part, outer * portable::cos(edge), outer * portable::sin(edge));
  end_line();
}

void box(const char* part, double left, double right, double low, double high) {
  for (const auto& [x, y] : {onggi::Vec2{left, low}, {right, low}, {right, high}, {left, high}})
    point(part, x, y);
  point(part, left, low);
  end_line();
}

bool draw() {
  onggi::SceneDef def;
  def.clay.rows = 20;
  def.clay.sectors = 96;
  def.clay.height = 0.1;
  def.clay.inner_radius = 0.04;
  def.tool.radius = kBall;
  auto scene = onggi::Scene::create(def);
  if (!scene) return false;
  const double half_sector = portable::kPi / def.clay.sectors;
  onggi::Hands hands;
  hands.hand[0].active = true;
  for (int n = 0; n < kTicks; ++n) {
    const double far = kFrom + (kTo - kFrom) * std::min(1.0, 4.0 * n / kTicks);
    hands.hand[0].position = {far * portable::cos(half_sector), kHeight,
                              far * portable::sin(half_sector)};
    scene->step(hands, 0.001);
  }
  const Clay& clay = scene->clay();
  const int row = clay.first_row_above(kHeight);
  for (int i = -9; i <= 9; ++i) element(clay, "level", row, i);
  // Elements are looked at by blocks of eight; the ball is over the end of one and the beginning
  // of the next.
  for (int i = -8; i < 8; ++i) element(clay, "level_looked", row, i);
  element(clay, "level_element", row, 5);
  for (int i = -9; i <= 9; ++i) arc(clay, "level_extent", i, double{clay.outer_most(row)}, false);
  end_line();
  for (int j = 0; j < clay.rows(); ++j) {
    const double low = clay.row_height(j) - 0.5 * clay.row_thickness(j);
    const double outer = double{clay.outer(j)[0]};
    const double inner = double{clay.inner(j)[0]};
    box("upright", inner, outer, low, low + clay.row_thickness(j));
    if (j == row + 3) box("upright_row", inner, outer, low, low + clay.row_thickness(j));
    point("extent", double{clay.outer_most(j)}, low);
    point("extent", double{clay.outer_most(j)}, low + clay.row_thickness(j));
    end_line();
  }
  std::fprintf(out, "figure,%.4f,%.4f\n", 1e3 * double{clay.outer(row)[0]},
               1e3 * clay.row_height(row));
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_glossary OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(out,
               "# A pot of 20 rows and 96 sectors that a ball of %.0f mm has pressed from outside:"
               " elements level through the\n"
               "# ball (x, mm; z, mm) and upright along its ray (radius, mm; height, mm); lines and"
               " polygons, an empty line after each.\n"
               "part,x_mm,y_mm\n",
               1e3 * kBall);
  const bool good = draw();
  return std::fclose(out) == 0 && good ? 0 : 1;
}
