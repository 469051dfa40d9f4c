#include "kiosk/visit/screens/target_line.h"

#include <algorithm>
#include <cmath>

#include "kiosk/visit/screens/strokes.h"

namespace onggi::screens {

double tolerance(const Profile& target) { return std::max(0.0012, 0.025 * target.max_radius()); }

namespace {
enum class Fit { near, wide, narrow };
constexpr int kSamples = 72;

struct Run {
  Fit fit;
  Points points;
};

/// How far `made` is outside `target` around height `h`: a mean over a finger's breadth, so that
/// throwing lines do not make the line flicker.
double beyond(const Profile& made, const Profile& target, double h) {
  if (made.points.empty()) return 0.0;
  constexpr int kReach = 3;
  double off = 0;
  for (int k = -kReach; k <= kReach; ++k) {
    const double at = std::clamp(h + 0.0015 * k, 0.0, target.height());
    off += made.outer_at(at) - target.outer_at(at);
  }
  return off / (2 * kReach + 1);
}

Vec3 beside(const view::Camera& camera, double r, double h) {
  Vec3 right, up, back;
  camera.basis(right, up, back);
  return {right.x * r, h, right.z * r};
}
}  // namespace

void draw_ghost(Page& page, const view::Camera& camera, const Profile& target,
                const Profile& made) {
  const float unit = page.type().body / 25.0f;
  const double near_enough = tolerance(target);
  for (const double side : {-1.0, 1.0}) {
    std::vector<Run> runs;
    for (int i = 0; i <= kSamples; ++i) {
      const double h = target.height() * i / kSamples;
      const double r = target.outer_at(h);
      const auto at = camera.project(beside(camera, side * r, h));
      if (!at) continue;
      const double off = beyond(made, target, h);
      const bool missing = !made.points.empty() && h > made.height() + near_enough;
      const Fit fit = missing              ? Fit::narrow
                      : off > near_enough  ? Fit::wide
                      : off < -near_enough ? Fit::narrow
                                           : Fit::near;
      if (runs.empty() || runs.back().fit != fit) {
        Run run{fit, {}};
        if (!runs.empty()) run.points.push_back(runs.back().points.back());
        runs.push_back(std::move(run));
      }
      runs.back().points.push_back(*at);
    }
    for (const Run& run : runs) {
      switch (run.fit) {
        case Fit::near:
          draw_stroke(page, run.points, view::kFaintInk, 1.6f * unit);
          break;
        case Fit::wide:
          // Iron red lies on clay of nearly its own colour and light.
          page.draw(view::Line{run.points, {view::kPlaster}, 6.4f * unit});
          draw_stroke(page, run.points, view::kIron, 2.8f * unit);
          break;
        case Fit::narrow:
          draw_dashes(page, run.points, view::kDeepCeladon, 2.8f * unit, 9.0f * unit);
          break;
      }
    }
  }
}

void draw_press(Page& page, const view::Camera& camera, const Profile& target, double height,
                bool inward) {
  const float unit = page.type().body / 25.0f;
  const auto at = camera.project(beside(camera, target.outer_at(height), height));
  if (!at) return;
  const auto [x, y] = *at;
  const float sign = inward ? 1.0f : -1.0f;
  const float tip = x + sign * 8 * unit, tail = tip + sign * 40 * unit, head = 9 * unit;
  const view::Color color = inward ? view::kIron : view::kDeepCeladon;
  draw_stroke(page, {{tail, y}, {tip, y}}, color, 2.4f * unit);
  draw_stroke(
      page, {{tip + sign * head, y - head * 0.7f}, {tip, y}, {tip + sign * head, y + head * 0.7f}},
      color, 2.4f * unit);
}

}  // namespace onggi::screens
