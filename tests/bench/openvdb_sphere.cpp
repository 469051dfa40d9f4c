#include <openvdb/openvdb.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/LevelSetSphere.h>
#include <openvdb/tools/SignedFloodFill.h>

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "tests/bench/goals.h"
#include "tests/bench/timing.h"
#include "tests/support/contact_tick.h"

namespace onggi::bench {
namespace {

// Below 0 in the clay of the lump, above outside it; the distance to the nearest face, m.
double distance_to(const ClayDef& def, double r, double y) {
  const double beyond_wall = std::max(r - def.outer_radius, def.inner_radius - r);
  return std::max({beyond_wall, y - def.height, -y});
}

// The script's lump as a narrow band level set.
openvdb::FloatGrid::Ptr level_set_of(const ClayDef& def, double voxel) {
  const double band = openvdb::LEVEL_SET_HALF_WIDTH * voxel;
  openvdb::FloatGrid::Ptr grid = openvdb::FloatGrid::create(static_cast<float>(band));
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  auto values = grid->getAccessor();
  const int wide = static_cast<int>(std::ceil((def.outer_radius + band) / voxel));
  const int low = static_cast<int>(std::floor(-band / voxel));
  const int high = static_cast<int>(std::ceil((def.height + band) / voxel));
  for (int i = -wide; i <= wide; ++i)
    for (int k = -wide; k <= wide; ++k)
      for (int j = low; j <= high; ++j) {
        const double distance = distance_to(def, voxel * std::hypot(i, k), voxel * j);
        if (std::fabs(distance) < band)
          values.setValue(openvdb::Coord(i, j, k), static_cast<float>(distance));
      }
  openvdb::tools::signedFloodFill(grid->tree());
  return grid;
}

}  // namespace

Figures openvdb_ratio(Effort effort) {
  openvdb::initialize();
  const TickScript& script = tick_script("light_touch");
  const SceneDef def = script.scene(400, 360);
  // As many voxels to the wall's area as there are elements.
  const double row = def.clay.height / def.clay.rows;
  const double arc = 2.0 * portable::kPi * def.clay.outer_radius / def.clay.sectors;
  const double voxel = std::sqrt(row * arc);
  const openvdb::FloatGrid::Ptr lump = level_set_of(def.clay, voxel);

  CorrectedContact contact(script, def.clay.rows, def.clay.sectors);
  openvdb::FloatGrid::Ptr clay = lump->deepCopy();
  std::vector<double> theirs;
  std::vector<double> ours;
  const int ticks = effort.ticks(1000);
  constexpr int kBatch = 20;
  for (int begin = 0; begin < ticks; begin += kBatch) {
    for (int n = begin; n < begin + kBatch; ++n) {
      // Making the tool's level set is not counted, though each subtraction uses one up.
      const Vec3 at = place_after(script, n);
      const openvdb::FloatGrid::Ptr ball = openvdb::tools::createLevelSetSphere<openvdb::FloatGrid>(
          static_cast<float>(def.tool.radius),
          openvdb::Vec3f(static_cast<float>(at.x), static_cast<float>(at.y),
                         static_cast<float>(at.z)),
          static_cast<float>(voxel));
      theirs.push_back(timed([&] { openvdb::tools::csgDifference(*clay, *ball); }));
    }
    for (int n = begin; n < begin + kBatch; ++n) ours.push_back(timed([&] { contact.tick(n); }));
  }
  const double openvdb_ns = times_of(theirs).median;
  const double ours_ns = times_of(ours).median;
  return {{"ratio_openvdb", openvdb_ns / ours_ns},
          {"openvdb_us", 1e-3 * openvdb_ns},
          {"corrected_us_beside_openvdb", 1e-3 * ours_ns},
          {"openvdb_voxel_mm", 1e3 * voxel}};
}

}  // namespace onggi::bench
