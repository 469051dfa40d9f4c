// The data of the figure of engine/docs/tools.md: the four bodies, askew, as the kernels and bounds
// see them. Sections are what a press that lasts leaves of a lump; silhouettes are what the support
// mapping reaches. Equal bits on every machine.
// usage: onggi_figure_bodies OUT.csv
#include <algorithm>
#include <cstdio>

#include "engine/contact/press.h"
#include "engine/math/portable.h"
#include "engine/math/unit.h"

namespace {

namespace portable = onggi::portable;
namespace body = onggi::body;
using onggi::Clay;
using onggi::unit;
using onggi::Vec3;
using onggi::WallSide;

constexpr Vec3 kAt{0.056, 0.05, 0.0};  // of every body: right of the axis
constexpr int kRay = 18;               // rays off the middle: the one whose interval is marked

std::FILE* out = nullptr;
const char* name = "";

void point(const char* part, double x, double y) {
  std::fprintf(out, "%s,%s,%.4f,%.4f,0\n", name, part, 1e3 * x, 1e3 * y);
}
void end_line() { std::fprintf(out, "\n"); }

onggi::ClayDef lump(bool thick) {
  onggi::ClayDef def;
  def.rows = 10;
  def.sectors = 4320;
  def.height = 0.1;
  def.floor_thickness = 0.0;
  def.outer_radius = thick ? 0.155 : 0.02;
  def.inner_radius = thick ? 0.15 - 0.0015 : 0.01;
  def.wall_min = 0.001;
  def.keep_undo = false;
  return def;
}

// A press of a minute: every face that meets the body lies at its end.
template <class Body>
void section(const Body& it) {
  constexpr onggi::Yielding kSoft{0.01, 5e6};
  Clay outside = std::move(*Clay::create(lump(true)));
  Clay inside = std::move(*Clay::create(lump(false)));
  press(outside, WallSide::outside, it, kAt, 60.0, kSoft);
  press(inside, WallSide::inside, it, kAt, 60.0, kSoft);
  const int row = outside.first_row_above(kAt.y);
  const double sector = 2.0 * portable::kPi / outside.sectors();
  const auto end = [&](const char* part, double r, int i) {
    const double angle = (i + 0.5) * sector;
    point(part, r * portable::cos(angle), r * portable::sin(angle));
  };
  const auto at = [&](int i) {
    return static_cast<std::size_t>((i + outside.sectors()) % outside.sectors());
  };
  // An element that an edge of the section crosses gives way for its share alone, and has not come
  // to its end: its two faces are still apart.
  const auto near = [&](int i) { return double{outside.outer(row)[at(i)]}; };
  const auto far = [&](int i) { return double{inside.inner(row)[at(i)]}; };
  constexpr int kMost = 600;
  int first = kMost;
  for (int i = -kMost; i <= kMost; ++i) {
    if (!(near(i) < far(i))) continue;
    first = std::min(first, i);
    end("section", near(i), i);
  }
  for (int i = kMost; i >= -kMost; --i)
    if (near(i) < far(i)) end("section", far(i), i);
  end("section", near(first), first);
  end_line();
  end("ray", 0.030, kRay);
  end("ray", 0.082, kRay);
  end_line();
  end("interval", near(kRay), kRay);
  end("interval", far(kRay), kRay);
  end_line();
}

// What the section lies within; a ball needs none.
template <class Body>
void outline(const Body& it) {
  const Clay clay = std::move(*Clay::create(lump(true)));
  const body::Outline o = it.outline(clay.row_height(clay.first_row_above(kAt.y)));
  const double round = double{o.round};
  for (int n = 0; n <= 720; ++n) {
    const double angle = n * portable::kPi / 360.0;
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    const auto side = [&](double u, double v) { return u * c + v * s < 0.0 ? -1.0 : 1.0; };
    const double a = side(double{o.ux}, double{o.uz});
    const double b = side(double{o.vx}, double{o.vz});
    point("outline", double{o.x} + a * double{o.ux} + b * double{o.vx} + round * c,
          double{o.z} + a * double{o.uz} + b * double{o.vz} + round * s);
  }
  end_line();
  const body::Hull hull = it.hull();
  for (int n = 0; n < hull.count; ++n) {
    const Vec3 p = hull.middle[static_cast<std::size_t>(n)];
    std::fprintf(out, "%s,hull,%.4f,%.4f,%.4f\n\n", name, 1e3 * p.x, 1e3 * p.y,
                 1e3 * (hull.radius > 0.0 ? hull.radius : 0.0006));
  }
  const body::Heights heights = it.heights();
  for (const double h : {heights.low, heights.high}) {
    point("heights", 0.030, h);
    point("heights", 0.082, h);
    end_line();
  }
}

// Where the farthest planes all round touch each other.
template <class Body>
void silhouette(const Body& it) {
  const auto farthest = [&](double angle) {
    const Vec3 towards{portable::cos(angle), portable::sin(angle), 0.0};
    const body::Ball ball = it.support(towards);
    return dot(ball.middle, towards) + ball.radius;
  };
  for (int n = 0; n <= 1440; ++n) {
    const double angle = n * portable::kPi / 720.0;
    constexpr double kStep = 1e-5;
    const double far = farthest(angle);
    const double slope = (farthest(angle + kStep) - farthest(angle - kStep)) / (2.0 * kStep);
    const double c = portable::cos(angle);
    const double s = portable::sin(angle);
    point("silhouette", far * c - slope * s, far * s + slope * c);
  }
  end_line();
  const Vec3 towards = unit({-0.45, -1.0, 0.0});
  const body::Ball ball = it.support(towards);
  const Vec3 p = ball.middle + ball.radius * towards;
  std::fprintf(out, "%s,support,%.4f,%.4f,%.4f\n\n", name, 1e3 * ball.middle.x, 1e3 * ball.middle.y,
               1e3 * ball.radius);
  point("point", p.x, p.y);
  end_line();
  point("towards", p.x, p.y);
  point("towards", p.x + 0.008 * towards.x, p.y + 0.008 * towards.y);
  end_line();
}

template <class Body>
void draw(const char* what, const Body& it) {
  name = what;
  section(it);
  if constexpr (requires { it.outline(0.0); }) outline(it);
  silhouette(it);
}

}  // namespace

int main(int argc, char** argv) {
  out = argc == 2 ? std::fopen(argv[1], "w") : nullptr;
  if (out == nullptr) {
    std::fprintf(stderr, "usage: onggi_figure_bodies OUT.csv (a file that can be written)\n");
    return 2;
  }
  std::fprintf(
      out,
      "# Four bodies beside the axis (at x = 0). Level, through the row at 55 mm (x, mm; z, mm):"
      " section, outline, a ray and its interval.\n"
      "# Upright (x, mm; height, mm): silhouette by the support mapping, one support ball"
      " (its radius beside), heights, hull.\n"
      "body,part,x_mm,y_mm,radius_mm\n");
  draw("ball", body::Ball{kAt, 0.012});
  const Vec3 lean = unit({0.55, 0.75, 0.3});
  draw("capsule", body::Capsule{kAt - 0.008 * lean, lean, 0.016, 0.006});
  const Vec3 along = unit({0.35, 0.9, 0.2});
  const Vec3 across = unit(cross(along, {0.25, 0.1, 1.0}));
  draw("box", body::Box{kAt, {along, across, cross(along, across)}, {0.013, 0.004, 0.009}});
  draw("cylinder", body::Cylinder(kAt, unit({0.45, 0.45, 1.0}), 0.012, 0.004));
  return std::fclose(out) == 0 ? 0 : 1;
}
