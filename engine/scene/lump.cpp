#include "engine/scene/lump.h"

#include <algorithm>
#include <cmath>

#include "engine/scene/wall_ring.h"

namespace onggi {
namespace {

constexpr double kFingertip = 0.008;   // m: a tool of this radius fits inside
constexpr double kKeptWall = 0.014;    // m: thick enough to stand
constexpr double kOpenedWall = 0.006;  // m: wall of a ring that opens as a whole to the belly
constexpr double kBuiltFloor = 0.01;   // m
constexpr int kFewestRows = 8;
constexpr double kBroad = 1.25;  // times the belly's radius: a lump to be cut down
// share of the target's height: least RMS distance from its outline
constexpr double kUnlike = 0.06;

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

// Widest radius of the target up to `height`, where clay is solid and no tool can push it out.
double widest_below(const Profile& target, double height) {
  double widest = target.outer_at(height);
  for (const ProfilePoint& p : target.points)
    if (p.height <= height) widest = std::max(widest, p.outer);
  return widest;
}

// Inner radius of a lump with the outer radius `outer`. If rings keep their clay, a bore of half
// the radius would close in a neck of half the belly. So the lump has only the belly's clay.
double bore(const Profile& target, const SceneDef& scene, double outer) {
  if (scene.volume) return outer - kKeptWall;
  if (!scene.walls) return 0.45 * outer;
  const double belly = std::max(target.max_radius(), kOpenedWall);
  const double area = scene::area_of({belly, belly - kOpenedWall});
  return std::min(std::sqrt(std::max(0.0, outer * outer - area)), outer - kOpenedWall);
}

// Sets the height at which `lump` has the target's volume. Kept clay gets higher where its ring
// loses area.
void weigh(const Profile& target, const SceneDef& scene, ClayDef& lump) {
  constexpr int kSlices = 400;
  const scene::WallRing ring{lump.outer_radius, lump.inner_radius};
  const double slice = target.height() / kSlices;
  const double floor = lump.floor_thickness;
  lump.height = lump.floor_thickness = 0.0;
  for (int n = 0; n < kSlices; ++n) {
    const double at = (n + 0.5) * slice;
    const double outer = std::max(target.outer_at(at), lump.radius_min + lump.wall_min);
    const bool solid = at < floor;
    const double share = solid ? outer * outer / (ring.outer * ring.outer)
                               : area_of(scene::worked(scene, ring, outer)) / area_of(ring);
    lump.height += slice * share;
    if (solid) lump.floor_thickness += slice * share;
  }
  lump.height = std::clamp(lump.height, 0.01, 1.0);
  lump.floor_thickness = std::max(lump.floor_thickness, lump.floor_min);
}

// The floor of a pot that is built of coils: a disc as wide as the target is halfway up it. On a
// round foot the widest place would stand out as a step, and no hand can press a solid floor in.
void beat_a_floor(const Profile& target, ClayDef& def) {
  const double row = def.height / def.rows;
  def.height = def.floor_thickness = scene::built_floor(def);
  def.rows = std::max(kFewestRows, static_cast<int>(std::lround(def.height / row)));
  def.inner_radius = def.radius_min;
  const double least = def.radius_min + def.wall_min + 0.001;
  def.outer_radius =
      std::clamp(target.outer_at(0.5 * def.height), least, std::max(least, 0.95 * def.radius_max));
}

}  // namespace

double scene::built_floor(const ClayDef& clay) { return std::max(kBuiltFloor, clay.floor_min); }

double workspace_scale(const Profile& target, double max_height, double max_diameter) {
  return std::min(max_height / target.height(), max_diameter / (2.0 * target.max_radius()));
}

ClayDef lump_for(const Profile& target, const SceneDef& scene) {
  const ClayDef& base = scene.clay;
  ClayDef def = base;
  if (scene.building) return beat_a_floor(target, def), def;
  def.height = std::clamp(target.height(), 0.01, 1.0);
  def.floor_thickness = std::min(base.floor_thickness, 0.1 * def.height);

  // A thick column well inside the target's belly, but not narrower than the target's foot, because
  // a solid floor cannot be pushed out.
  const double belly = target.max_radius();
  const double foot = 1.02 * widest_below(target, def.floor_thickness + 0.4 * kFingertip);
  const double room = kFingertip + 0.002;  // least inner radius
  const double roomy = room + (scene.volume ? kKeptWall : def.wall_min + 0.006);
  const double most_outer = 0.95 * base.radius_max;
  double best = std::max({0.58 * belly, foot, roomy});
  // If that is near the outline itself (a cylinder, a wide foot), use a broad lump to be cut down.
  if (mean_distance(target, best) < kUnlike * target.height() || best > belly)
    best = std::max(kBroad * belly, roomy);
  best = std::min(best, most_outer);
  def.outer_radius = best;
  const double most = best - def.wall_min - 0.001;
  def.inner_radius =
      std::max(std::min(std::max(bore(target, scene, best), room), most), def.radius_min);
  if (scene.volume) weigh(target, scene, def);
  return def;
}

}  // namespace onggi
