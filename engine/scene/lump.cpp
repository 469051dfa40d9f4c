#include <algorithm>
#include <cmath>

#include "engine/scene/scene_def.h"

namespace onggi {
namespace {

// Mean square distance of the target's outline from a cylinder of `radius`, m^2.
double unlikeness(const Profile& target, double radius) {
  constexpr int kSlices = 100;
  double sum = 0.0;
  for (int n = 0; n < kSlices; ++n) {
    const double off = target.outer_at((n + 0.5) / kSlices * target.height()) - radius;
    sum += off * off;
  }
  return sum / kSlices;
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
  constexpr double kFingertip = 0.008;  // room for a tool of this radius inside
  ClayDef def = base;
  def.height = std::clamp(target.height(), 0.01, 1.0);
  def.floor_thickness = std::min(base.floor_thickness, 0.1 * def.height);

  // The solid foot can only be cut narrower, so the lump is at least as wide as the target there.
  // Of the widths a potter would centre, take the one farthest from the target's outline.
  const double belly = target.max_radius();
  const double foot = 1.02 * widest_below(target, def.floor_thickness + 0.4 * kFingertip);
  const double room = kFingertip + 0.002;  // inner radius at the least
  const double narrowest = std::max({foot, room + def.wall_min + 0.006, 0.55 * belly});
  const double widest = std::min(1.4 * belly, 0.95 * base.radius_max);
  double best = std::min(narrowest, widest);
  for (const double share : {0.55, 0.58, 0.62, 1.25, 1.32, 1.4}) {
    const double radius = share * belly;
    // Narrow lumps first: a wide one must be clearly farther off to be worth its clay.
    const double margin = radius > belly ? 1.5 : 1.0;
    if (radius >= narrowest && radius <= widest &&
        unlikeness(target, radius) > margin * unlikeness(target, best))
      best = radius;
  }
  def.outer_radius = best;
  const double most = best - def.wall_min - 0.001;
  def.inner_radius = std::max(std::min(std::max(0.45 * best, room), most), def.radius_min);
  return def;
}

}  // namespace onggi
