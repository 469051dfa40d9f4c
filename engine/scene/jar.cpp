#include "engine/scene/jar.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/math/portable.h"
#include "engine/profile/capacity.h"
#include "engine/scene/lump.h"
#include "engine/scene/wall_ring.h"

namespace onggi {

namespace {

constexpr int kJarSlices = 200;
constexpr double kFootShare = 0.62, kMouthShare = 0.74;  // of the belly's radius
constexpr double kBellyAt = 0.55;                        // of the height
constexpr double kSlim = 1.9;                            // height over the belly's radius
constexpr double kWidest = 0.11, kNarrowest = 0.018;     // m: the belly's radius
constexpr double kTallest = 0.2;                         // m
constexpr double kDrawnWall = 0.006;  // m: wall of the outline for which a lump is laid
constexpr double kExact = 0.001;      // relative error of the volume

double radius_of(double share, double belly, double mouth) {
  const double quarter = 0.5 * portable::kPi;
  const double foot = kFootShare * belly;
  if (share < kBellyAt) return foot + (belly - foot) * portable::sin(quarter * share / kBellyAt);
  return mouth + (belly - mouth) * portable::cos(quarter * (share - kBellyAt) / (1.0 - kBellyAt));
}

Profile jar_of(const JarWish& wish, const SceneDef& scene, double belly) {
  const double height =
      std::clamp(kSlim * belly, wish.height_least, std::min(wish.height_most, kTallest));
  const double mouth =
      0.5 * std::clamp(2.0 * kMouthShare * belly, wish.mouth_least, wish.mouth_most);
  Profile jar;
  for (int n = 0; n <= kJarSlices; ++n) {
    const double share = static_cast<double>(n) / kJarSlices;
    const double outer = radius_of(share, belly, mouth);
    jar.points.push_back({share * height, outer, std::max(outer - kDrawnWall, 0.0)});
  }
  // The inside follows from the lump: a ring keeps its clay, or its wall gets thin.
  const ClayDef lump = lump_for(jar, scene);
  const scene::WallRing ring{lump.outer_radius, lump.inner_radius};
  const double floor = std::min(lump.floor_thickness, 0.5 * height);
  for (ProfilePoint& p : jar.points)
    p.inner = p.height < floor ? 0.0
                               : std::clamp(scene::worked(scene, ring, p.outer).inner, 0.0,
                                            p.outer - scene.clay.wall_min);
  return jar;
}

}  // namespace

Result<Profile> jar_that_holds(const JarWish& wish, const SceneDef& scene) {
  double small = kNarrowest, large = kWidest;
  Profile jar = jar_of(wish, scene, small);
  const auto near = [&wish](const Profile& p) {
    return std::abs(capacity(p) - wish.volume) <= kExact * wish.volume;
  };
  for (int n = 0; n < 60 && !near(jar); ++n) {
    const double belly = 0.5 * (small + large);
    jar = jar_of(wish, scene, belly);
    (capacity(jar) < wish.volume ? small : large) = belly;
  }
  if (near(jar)) return jar;
  const auto text = [](double value) {
    const auto hundredths = static_cast<long>(value * 1e5 + 0.5);
    return std::to_string(hundredths / 100) + '.' + std::to_string(hundredths / 10 % 10) +
           std::to_string(hundredths % 10);
  };
  return problem("a jar that holds " + text(wish.volume) + " litres",
                 "The nearest jar that fits this wheel and its bounds holds " +
                     text(capacity(jar)) + " litres.",
                 "Ask for another volume, or widen height_mm and mouth_mm.");
}

}  // namespace onggi
