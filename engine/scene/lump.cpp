#include <algorithm>
#include <cmath>

#include "engine/scene/scene_def.h"

namespace onggi {
namespace {

constexpr double kFingertip = 0.008;  // room for a tool of this radius inside
constexpr double kUnlike = 0.06;      // RMS distance from the target's outline, of its height

// RMS distance of the target's outline from a cylinder of `radius`, m.
double mean_distance(const Profile& target, double radius) {
  constexpr int kSlices = 100;
  double sum = 0.0;
  for (int n = 0; n < kSlices; ++n) {
    const double off = target.outer_at((n + 0.5) / kSlices * target.height()) - radius;
    sum += off * off;
  }
  return std::sqrt(sum / kSlices);
}

// Widest radius of the target up to `height`: clay that no tool inside can push out.
double widest_below(const Profile& target, double height) {
  double widest = target.outer_at(height);
  for (const ProfilePoint& p : target.points)
    if (p.height <= height) widest = std::max(widest, p.outer);
  return widest;
}

}  // namespace

double workspace_scale(const Profile& target, double max_height, double max_diameter) {
  return std::min(max_height / target.height(), max_diameter / (2.0 * target.max_radius()));
}

ClayDef lump_for(const Profile& target, const ClayDef& base) {
  ClayDef def = base;
  def.height = std::clamp(target.height(), 0.01, 1.0);
  def.floor_thickness = std::min(base.floor_thickness, 0.1 * def.height);

  // A thick column well inside the target's belly, but no narrower than the target's foot: the
  // floor is solid, and nothing can push it out.
  const double belly = target.max_radius();
  const double foot = 1.02 * widest_below(target, def.floor_thickness + 0.4 * kFingertip);
  const double room = kFingertip + 0.002;  // inner radius at the least
  const double roomy = room + def.wall_min + 0.006;
  const double most_outer = 0.95 * base.radius_max;
  double best = std::max({0.58 * belly, foot, roomy});
  // Where that is near the outline itself (a cylinder, a wide foot), a broad lump is cut down
  // instead.
  if (mean_distance(target, best) < kUnlike * target.height() || best > belly)
    best = std::max(1.4 * belly, roomy);
  best = std::min(best, most_outer);
  def.outer_radius = best;
  const double most = best - def.wall_min - 0.001;
  def.inner_radius = std::max(std::min(std::max(0.45 * best, room), most), def.radius_min);
  return def;
}

}  // namespace onggi
