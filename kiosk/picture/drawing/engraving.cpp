#include "kiosk/picture/drawing/engraving.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/math/unit.h"
#include "kiosk/picture/view/palette.h"

namespace onggi::drawing {

namespace {

constexpr int kFine = 2;  // samples a pixel in each direction
/// A larger step in depth, as a share of the picture's height, is an edge.
constexpr float kStep = 0.012f;
/// A surface that turns by more than about 35 degrees is an edge too.
constexpr float kCrease = 0.82f;

struct Sample {
  float depth = -std::numeric_limits<float>::infinity();  // larger is nearer
  float nx = 0, ny = 0, nz = 0;
  bool left_out = false;
};

double limit_at(std::span<const Vec2> limit, double h) {
  if (limit.empty()) return 1e300;
  const auto above = std::upper_bound(limit.begin(), limit.end(), h,
                                      [](double y, const Vec2& p) { return y < p.y; });
  if (above == limit.begin()) return limit.front().x;
  if (above == limit.end()) return limit.back().x;
  const Vec2 &a = *(above - 1), &b = *above;
  return a.x + (b.x - a.x) * (h - a.y) / std::max(b.y - a.y, 1e-12);
}

class Plate {
 public:
  Plate(const EngravingWindow& window, std::span<const Vec2> limit)
      : window_(window),
        limit_(limit),
        scale_(window.pixels_per_metre * kFine),
        width_(fine(window.right - window.left)),
        height_(fine(window.top - window.bottom)),
        samples_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {}

  void press(const TriangleMesh& mesh);
  view::Image print() const;

 private:
  int fine(double metres) const {
    const auto pixels = static_cast<int>(std::ceil(metres * window_.pixels_per_metre));
    return kFine * std::clamp(pixels, 1, 8000);
  }
  const Sample& at(int x, int y) const {
    return samples_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x)];
  }
  float edge(int x, int y) const;

  EngravingWindow window_;
  std::span<const Vec2> limit_;
  double scale_;
  int width_, height_;
  std::vector<Sample> samples_;
};

void Plate::press(const TriangleMesh& mesh) {
  const bool smooth = mesh.normals.size() == mesh.positions.size();
  for (const auto& t : mesh.triangles) {
    Vec3 p[3], n[3];
    double x[3], y[3];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& q = mesh.positions[t[k]];
      p[k] = {q[0], q[1], q[2]};
      x[k] = (p[k].x - window_.left) * scale_;
      y[k] = (window_.top - p[k].y) * scale_;
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    if (area == 0.0 || !std::isfinite(area)) continue;
    const Vec3 flat = cross(p[1] - p[0], p[2] - p[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      n[k] = flat;
      if (!smooth) continue;
      const auto& q = mesh.normals[t[k]];
      n[k] = {q[0], q[1], q[2]};
    }
    const auto first = [](double v, int most) {
      return static_cast<int>(std::clamp(std::ceil(v - 0.5), 0.0, static_cast<double>(most)));
    };
    const int x0 = first(std::min({x[0], x[1], x[2]}), width_),
              x1 = first(std::max({x[0], x[1], x[2]}), width_),
              y0 = first(std::min({y[0], y[1], y[2]}), height_),
              y1 = first(std::max({y[0], y[1], y[2]}), height_);
    for (int row = y0; row < y1; ++row)
      for (int column = x0; column < x1; ++column) {
        const double px = column + 0.5, py = row + 0.5;
        const double w0 = ((x[1] - px) * (y[2] - py) - (x[2] - px) * (y[1] - py)) / area;
        const double w1 = ((x[2] - px) * (y[0] - py) - (x[0] - px) * (y[2] - py)) / area;
        const double w2 = 1.0 - w0 - w1;
        if (w0 < 0.0 || w1 < 0.0 || w2 < 0.0) continue;
        const Vec3 here = p[0] * w0 + p[1] * w1 + p[2] * w2;
        Sample& s = samples_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                             static_cast<std::size_t>(column)];
        if (static_cast<float>(here.z) <= s.depth) continue;
        Vec3 normal = n[0] * w0 + n[1] * w1 + n[2] * w2;
        // A scan's surface may be wound either way; a visible face counts as facing the eye.
        if (normal.z < 0.0) normal = -normal;
        const double size = length(normal);
        if (!(size > 0.0)) continue;
        const double r = std::sqrt(here.x * here.x + here.z * here.z);
        s = {static_cast<float>(here.z), static_cast<float>(normal.x / size),
             static_cast<float>(normal.y / size), static_cast<float>(normal.z / size),
             r > limit_at(limit_, here.y)};
      }
  }
}

/// How much of a line lies on a sample, 0..1.
float Plate::edge(int x, int y) const {
  const Sample& s = at(x, y);
  const auto step = static_cast<float>(kStep * (window_.top - window_.bottom));
  float line = 0.0f;
  for (const auto& [dx, dy] :
       {std::pair{1, 0}, std::pair{-1, 0}, std::pair{0, 1}, std::pair{0, -1}}) {
    if (x + dx < 0 || y + dy < 0 || x + dx >= width_ || y + dy >= height_) continue;
    const Sample& o = at(x + dx, y + dy);
    if (std::isinf(o.depth)) return 1.0f;
    // On a slope that recedes from the eye, neighbours are far apart without a break.
    if (s.depth - o.depth > step && s.depth - o.depth > 3.0f * step * (1.0f - s.nz)) line = 1.0f;
    if (s.nx * o.nx + s.ny * o.ny + s.nz * o.nz < kCrease) line = std::max(line, 0.55f);
  }
  return line;
}

view::Image Plate::print() const {
  view::Image out;
  out.width = width_ / kFine;
  out.height = height_ / kFine;
  out.rgba.assign(static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height) * 4,
                  0);
  // From the upper left, the convention of drawings.
  const Vec3 light = unit(Vec3{-0.52, 0.56, 0.65});
  for (int py = 0; py < out.height; ++py)
    for (int px = 0; px < out.width; ++px) {
      float r = 0, g = 0, b = 0, a = 0;
      for (int k = 0; k < kFine * kFine; ++k) {
        const int x = px * kFine + k % kFine, y = py * kFine + k / kFine;
        const Sample& s = at(x, y);
        if (std::isinf(s.depth)) continue;
        // Half of the light reaches round the form, so that no part disappears in shadow.
        const double lit = 0.5 + 0.5 * (s.nx * light.x + s.ny * light.y + s.nz * light.z);
        const auto tone = static_cast<float>(0.36 + 0.62 * lit * std::sqrt(lit));
        const view::Color paper = s.left_out ? view::rgb(0xE9B08F) : view::rgb(0xFBF7F0);
        const view::Color shade = s.left_out ? view::kIron : view::rgb(0x4A423A);
        const float line = 0.85f * edge(x, y);
        const auto mix = [&](float light_part, float dark_part) {
          const float v = dark_part + (light_part - dark_part) * tone;
          return v * (1.0f - line) + line * dark_part * 0.6f;
        };
        r += mix(paper.r, shade.r);
        g += mix(paper.g, shade.g);
        b += mix(paper.b, shade.b);
        a += 1.0f;
      }
      if (a <= 0.0f) continue;
      std::uint8_t* to =
          &out.rgba[(static_cast<std::size_t>(py) * static_cast<std::size_t>(out.width) +
                     static_cast<std::size_t>(px)) *
                    4];
      const auto byte = [](float v) {
        return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
      };
      to[0] = byte(r / a);
      to[1] = byte(g / a);
      to[2] = byte(b / a);
      to[3] = byte(a / static_cast<float>(kFine * kFine));
    }
  return out;
}

}  // namespace

view::Image engrave(const TriangleMesh& mesh, std::span<const Vec2> limit,
                    const EngravingWindow& window) {
  Plate plate(window, limit);
  plate.press(mesh);
  return plate.print();
}

}  // namespace onggi::drawing
