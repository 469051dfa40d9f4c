#include "engine/effects/beating.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/effect_list.h"
#include "engine/effects/laid_coil.h"
#include "engine/math/portable.h"

namespace onggi {

std::span<const DefField<BeatingDef>> BeatingDef::fields() {
  static constexpr DefField<BeatingDef> kFields[] = {
      {"energy", &BeatingDef::energy, 0.001, 2.0, "J"},
      {"face", &BeatingDef::face, 0.005, 0.08, "m"},
      {"yield_stress", &BeatingDef::yield_stress, 5e3, 1e6, "Pa"},
  };
  return kFields;
}

namespace effects {
namespace {

constexpr double kFarthest = 0.03;     // m from the wall: a blow from farther away hits nothing
constexpr double kMostThinner = 0.25;  // of the wall, in a blow

// A paddle's face gives way round its edge. So a blow has no ridge there.
double face_at(double square) { return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0; }

// Where a blow lands. The wall is taken to be upright: on a wall that leans, the face is as high as
// its shadow on an upright one.
struct Patch {
  WallSide side = WallSide::outside;
  double radius = 0.0;  // m, of the face that is struck, in the middle
  double across = 0.0;  // m, half the patch round the ring: at most the radius, on a thin neck
  double up = 0.0;      // m, half its height
  double x = 0.0, z = 0.0, y = 0.0;  // its middle: a unit vector, and m
  int first = 0, end = 0;            // rows

  double of_sector(const Clay& clay, std::size_t i) const {
    const double dx = double{clay.ray_cos()[i]} - x, dz = double{clay.ray_sin()[i]} - z;
    return (dx * dx + dz * dz) * radius * radius / (across * across);
  }
  double of_row(const Clay& clay, int j) const {
    const double dy = (clay.row_height(j) - y) / up;
    return dy * dy;
  }
};

// Where `blow` meets the wall; no rows if it misses.
Patch patch_of(const BeatingDef& def, const Clay& clay, const Blow& blow) {
  Patch patch;
  const double out = length(Vec2{blow.at.x, blow.at.z});
  const int j = std::clamp(clay.first_row_above(blow.at.y), clay.floor_rows(), clay.rows() - 1);
  if (j < clay.floor_rows()) return patch;  // a solid lump has no wall
  const auto i = static_cast<std::size_t>(sector_at(clay, blow.at));
  const bool outside = blow.side == WallSide::outside;
  patch.side = blow.side;
  patch.radius = double{(outside ? clay.outer(j) : clay.inner(j))[i]};
  if (std::fabs(out - patch.radius) > kFarthest || !(out > 0.0)) return patch;
  patch.across = std::min(def.face, patch.radius);
  patch.up = def.face;
  patch.x = blow.at.x / out;
  patch.z = blow.at.z / out;
  patch.y = blow.at.y;
  patch.first = std::max(clay.first_row_above(patch.y - patch.up), clay.floor_rows());
  patch.end = clay.first_row_above(patch.y + patch.up);
  return patch;
}

// Sums over the patch.
struct Under {
  double area = 0.0;    // of the face's weight, m^2
  double bend = 0.0;    // of weight^2 / wall, m
  double volume = 0.0;  // of weight times wall, m^3
};
Under under(const Clay& clay, const Patch& patch) {
  Under sums;
  const double wide = patch.radius * 2.0 * portable::kPi / clay.sectors();
  for (int j = patch.first; j < patch.end; ++j) {
    const double row = patch.of_row(clay, j);
    const double area = wide * clay.row_thickness(j);
    const std::span<const float> outer = clay.outer(j), inner = clay.inner(j);
    for (std::size_t i = 0; i < outer.size(); ++i) {
      const double w = face_at(row + patch.of_sector(clay, i));
      const double wall = double{outer[i]} - double{inner[i]};
      sums.area += w * area;
      sums.bend += w * w / wall * area;
      sums.volume += w * wall * area;
    }
  }
  return sums;
}

// Thins row `j`'s wall by `thinner` (m) in the middle of the patch, or moves it by `moved` away
// from the side that is struck. Returns the ring's mean of ln(wall before / wall after), to second
// order: 3e-4 too little where a blow takes a tenth of the wall.
double press_row(Clay& clay, const Patch& patch, int j, double thinner, double moved) {
  const ClayDef& lump = clay.def();
  const bool outside = patch.side == WallSide::outside;
  const double row = patch.of_row(clay, j);
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  const bool rigid = clay.areas()->rigid(j);  // the pot may get no higher
  double sum = 0.0;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const double w = face_at(row + patch.of_sector(clay, i));
    if (w == 0.0) continue;
    const double wall = double{outer[i]} - double{inner[i]};
    const double least = lump.wall_min * (1.0 + 1e-6);
    const double most = rigid ? 0.0 : std::clamp(wall - least, 0.0, kMostThinner * wall);
    const double thins = std::min(w * thinner, most);
    const double room =
        outside ? double{inner[i]} - lump.radius_min : lump.radius_max - double{outer[i]};
    const double moves = std::min(w * moved, std::max(0.0, room));
    // Paddle and anvil go in alike.
    const double way = outside ? -moves : moves;
    outer[i] = static_cast<float>(double{outer[i]} + way - 0.5 * thins);
    inner[i] = static_cast<float>(double{inner[i]} + way + 0.5 * thins);
    sum += thins / wall * (1.0 + 0.5 * thins / wall);
  }
  return sum / clay.sectors();
}

// Clay that leaves from between paddle and anvil goes round and up alike. So half of what a ring
// got thinner makes it wider, all round, and Volume makes it higher by the other half.
void spread_row(Clay& clay, int j, double thinner) {
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  double middles = 0.0;
  for (std::size_t i = 0; i < outer.size(); ++i)
    middles += 0.5 * (double{outer[i]} + double{inner[i]});
  const double room = clay.def().radius_max - double{*std::ranges::max_element(outer)};
  const double wider =
      std::clamp(0.5 * thinner * middles / clay.sectors(), 0.0, std::max(0.0, room));
  for (float& r : outer) r += static_cast<float>(wider);
  for (float& r : inner) r += static_cast<float>(wider);
}

void was_struck(Clay& clay, int j) {
  clay.set_extent(j, *std::ranges::max_element(clay.outer(j)),
                  *std::ranges::min_element(clay.inner(j)));
  clay.areas()->set(j, clay.measured_area(j));
  clay.areas()->mark(j);
  clay.mark_dirty(j);
}

// Share of its strength that water leaves the wall where the blow lands.
double strength_at(const StageWork& work, const Patch& patch) {
  if (work.tick.moisture == nullptr) return 1.0;
  return strength(*work.def.moisture, work.tick.moisture->at(work.clay, patch.y));
}

Struck strike(const StageWork& work, const Blow& blow) {
  const BeatingDef& def = *work.def.beating;
  Clay& clay = work.clay;
  const Patch patch = patch_of(def, clay, blow);
  const Under sums = under(clay, patch);
  if (!(sums.area > 0.0)) return {};
  const double wall = sums.volume / sums.area;
  const double stress = def.yield_stress * strength_at(work, patch);
  const double held = std::clamp(blow.held, 0.0, 1.0);
  const bool outside = blow.side == WallSide::outside;

  // Against an anvil: the mean pressure on a disc between two rough plates. The work is the stress
  // times the logarithm of the wall's thinning, to second order.
  const double face = std::sqrt(patch.across * patch.up);
  const double pressure = stress * (1.0 + 2.0 * face / (3.0 * std::sqrt(3.0) * wall));
  const double squeeze = held * def.energy / pressure;
  const double thinner =
      (std::sqrt(sums.area * sums.area + 2.0 * sums.bend * squeeze) - sums.area) / sums.bend;
  // Without one: the load at which a clamped plate folds, as in wall_bears(). The hand stops the
  // paddle after a wall's thickness at the latest.
  const double load = portable::kPi * stress * wall * wall;
  const double moved = std::min((1.0 - held) * def.energy / load, wall);

  for (int j = patch.first; j < patch.end; ++j) {
    const double thins = press_row(clay, patch, j, thinner, moved);
    spread_row(clay, j, thins);
    was_struck(clay, j);
    if (work.building != nullptr) work.building->beat(clay.stored(j), thins);
  }
  const double way = outside ? 1.0 : -1.0;
  return {held * pressure * sums.area + (1.0 - held) * load, thinner, moved,
          Vec3{way * patch.x, 0.0, way * patch.z}};
}

}  // namespace

bool Beating::wanted(const Effects& def) { return def.beating.has_value(); }

void Beating::run(const StageWork& work) noexcept {
  for (std::size_t n = 0; n < struck_.size(); ++n)
    struck_[n] = work.tick.blow[n].lands ? strike(work, work.tick.blow[n]) : Struck{};
}

}  // namespace effects
}  // namespace onggi
