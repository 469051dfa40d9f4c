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
constexpr double kNear = 1e-6;         // of the work: Newton's steps end

// A paddle's face gives way round its edge. So a blow has no ridge there.
double face_at(double square) { return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0; }

// Where a blow lands. The wall is taken to be upright: on a wall that leans, the face is as high as
// its shadow on an upright one.
struct Patch {
  WallSide side = WallSide::outside;  // the face that is struck
  double radius = 0.0;                // m, of that face in the middle
  double across = 0.0;  // m, half the patch round the ring: at most the radius, on a thin neck
  double up = 0.0;      // m, half its height
  double x = 0.0, z = 0.0, y = 0.0;   // its middle: a unit vector, and m
  int first = 0, end = 0;             // rows,
  int first_sector = 0, sectors = 0;  // and sectors, onwards round the ring
};

// Calls `visit` with row, sector, the face's weight there (0..1), and the place on the face (-1..1
// round and up) for each element of the patch.
template <class Visit>
void each_element(const Clay& clay, const Patch& patch, int j, Visit&& visit) {
  const double up = (clay.row_height(j) - patch.y) / patch.up;
  for (int k = 0; k < patch.sectors; ++k) {
    const auto i = static_cast<std::size_t>((patch.first_sector + k) % clay.sectors());
    const double dx = double{clay.ray_cos()[i]} - patch.x, dz = double{clay.ray_sin()[i]} - patch.z;
    const double round = (dz * patch.x - dx * patch.z) * patch.radius / patch.across;
    const double chord = (dx * dx + dz * dz) * patch.radius * patch.radius;
    const double w = face_at(up * up + chord / (patch.across * patch.across));
    if (w > 0.0) visit(i, w, round, up);
  }
}
template <class Visit>
void each_element(const Clay& clay, const Patch& patch, Visit&& visit) {
  for (int j = patch.first; j < patch.end; ++j)
    each_element(clay, patch, j, [&](std::size_t i, double w, double round, double up) {
      visit(j, i, w, round, up);
    });
}

double wall_at(const Clay& clay, int j, std::size_t i) {
  return double{clay.outer(j)[i]} - double{clay.inner(j)[i]};
}

// Where `blow` meets the wall; no rows if it misses.
Patch patch_of(const BeatingDef& def, const Clay& clay, const Blow& blow) {
  Patch patch;
  const double out = length(Vec2{blow.at.x, blow.at.z});
  const int j = std::clamp(clay.first_row_above(blow.at.y), clay.floor_rows(), clay.rows() - 1);
  if (j < clay.floor_rows()) return patch;  // a solid lump has no wall
  const int middle = sector_at(clay, blow.at);
  const bool outside = blow.side == WallSide::outside;
  const auto i = static_cast<std::size_t>(middle);
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
  // The chord is no longer than `across`, so the arc is at most pi / 3 of it.
  const double arc = portable::kPi / 3.0 * patch.across / patch.radius;
  const int n = clay.sectors();
  const int half = static_cast<int>(std::ceil(arc * n / (2.0 * portable::kPi))) + 1;
  patch.sectors = std::min(2 * half + 1, n);
  patch.first_sector = (middle - half + n) % n;
  return patch;
}

// What lies under the paddle, or under the anvil: a face of the wall.
struct Face {
  bool outside = true;
  double area = 0.0;  // of the weights, m^2
  double wall = 0.0;  // their mean, m
  // The even face on which the tool comes to lie: radius = mean + round ... + up ..., m.
  double mean = 0.0, by_round = 0.0, by_up = 0.0;
  double round = 0.0, up = 0.0;  // the weights' middle
  double deep = 0.0;  // m: how far beyond it the tool goes in; less than 0: only on what stands out

  // How far the tool goes into an element of `radius`, m.
  double into(double radius, double w, double at_round, double at_up) const {
    const double even = mean + by_round * (at_round - round) + by_up * (at_up - up);
    const double proud = outside ? radius - even : even - radius;
    return std::max(0.0, w * (deep + proud));
  }
};
double radius_of(const Clay& clay, bool outside, int j, std::size_t i) {
  return double{(outside ? clay.outer(j) : clay.inner(j))[i]};
}
double area_of(const Clay& clay, const Patch& patch, int j) {
  return patch.radius * 2.0 * portable::kPi / clay.sectors() * clay.row_thickness(j);
}

// The least squares of the radii, by weight. The two slopes are found one by one: a patch that the
// rim or the floor cuts off is still even round its middle.
Face face_of(const Clay& clay, const Patch& patch, bool outside) {
  Face face;
  face.outside = outside;
  each_element(clay, patch, [&](int j, std::size_t i, double w, double round, double up) {
    const double area = w * area_of(clay, patch, j);
    face.area += area;
    face.wall += area * wall_at(clay, j, i);
    face.mean += area * radius_of(clay, outside, j, i);
    face.round += area * round;
    face.up += area * up;
  });
  if (!(face.area > 0.0)) return face;
  for (double* sum : {&face.wall, &face.mean, &face.round, &face.up}) *sum /= face.area;
  double rounds = 0.0, ups = 0.0;
  each_element(clay, patch, [&](int j, std::size_t i, double w, double round, double up) {
    const double area = w * area_of(clay, patch, j);
    const double proud = radius_of(clay, outside, j, i) - face.mean;
    rounds += area * (round - face.round) * (round - face.round);
    ups += area * (up - face.up) * (up - face.up);
    face.by_round += area * (round - face.round) * proud;
    face.by_up += area * (up - face.up) * proud;
  });
  face.by_round = rounds > 0.0 ? face.by_round / rounds : 0.0;
  face.by_up = ups > 0.0 ? face.by_up / ups : 0.0;
  return face;
}

// How deep the tool goes in for `work` / pressure (m^3): the sum of x + x^2 / wall over the area,
// with x of Face::into(). That is Y ln(wall / (wall - 2 x)) to second order, of which each face has
// a half. The sum is convex and rises with the depth, so Newton's steps from above fall to the
// root.
void go_in(const Clay& clay, const Patch& patch, double work, Face& face) {
  double most = 0.0;
  each_element(clay, patch, [&](int j, std::size_t i, double, double round, double up) {
    const double even =
        face.mean + face.by_round * (round - face.round) + face.by_up * (up - face.up);
    most = std::max(most, std::fabs(radius_of(clay, face.outside, j, i) - even));
  });
  constexpr int kSteps = 12;  // 4 are enough on an even wall, 8 on a ridged one
  face.deep = most + work / face.area;
  for (int step = 0; step < kSteps; ++step) {
    double sum = 0.0, slope = 0.0;
    each_element(clay, patch, [&](int j, std::size_t i, double w, double round, double up) {
      const double x = face.into(radius_of(clay, face.outside, j, i), w, round, up);
      if (x == 0.0) return;
      const double area = area_of(clay, patch, j), wall = wall_at(clay, j, i);
      sum += (x + x * x / wall) * area;
      slope += w * (1.0 + 2.0 * x / wall) * area;
    });
    if (!(slope > 0.0) || sum - work <= kNear * work) return;
    face.deep -= (sum - work) / slope;
  }
}

// What a blow does to the patch.
struct Work {
  bool squeezes = false;
  Face outer, inner;   // only if it squeezes
  double moved = 0.0;  // m, in the middle
};

// Moves the elements of row `j`. Returns the ring's mean of ln(wall before / wall after), to second
// order: 3e-4 too little where a blow takes a tenth of the wall.
double press_row(Clay& clay, const Patch& patch, int j, const Work& work) {
  const ClayDef& lump = clay.def();
  const bool from_outside = patch.side == WallSide::outside;
  const bool rigid = clay.areas()->rigid(j);  // the pot may get no higher
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  double sum = 0.0;
  each_element(clay, patch, j, [&](std::size_t i, double w, double round, double up) {
    const double wall = double{outer[i]} - double{inner[i]};
    const double least = lump.wall_min * (1.0 + 1e-6);
    const double most = rigid ? 0.0 : std::clamp(wall - least, 0.0, kMostThinner * wall);
    double out = 0.0, in = 0.0;
    if (work.squeezes) {
      out = work.outer.into(double{outer[i]}, w, round, up);
      in = work.inner.into(double{inner[i]}, w, round, up);
    }
    const double share = out + in > most ? most / (out + in) : 1.0;
    const double room =
        from_outside ? double{inner[i]} - lump.radius_min : lump.radius_max - double{outer[i]};
    const double moves = std::min(w * work.moved, std::max(0.0, room));
    const double way = from_outside ? -moves : moves;
    outer[i] = static_cast<float>(double{outer[i]} + way - share * out);
    inner[i] = static_cast<float>(double{inner[i]} + way + share * in);
    const double thins = share * (out + in) / wall;
    sum += thins * (1.0 + 0.5 * thins);
  });
  return sum / clay.sectors();
}

// How much of row `j` lies under the face, 0..1 of a ring.
double under_face(const Clay& clay, const Patch& patch, int j) {
  double sum = 0.0;
  each_element(clay, patch, j, [&](std::size_t, double w, double, double) { sum += w; });
  return sum / clay.sectors();
}

// Makes row `j` wider all round, by the share `wider` of its middle.
void widen_row(Clay& clay, int j, double wider) {
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  double middles = 0.0;
  for (std::size_t i = 0; i < outer.size(); ++i)
    middles += 0.5 * (double{outer[i]} + double{inner[i]});
  const double room = clay.def().radius_max - double{*std::ranges::max_element(outer)};
  const double by = std::clamp(wider * middles / clay.sectors(), 0.0, std::max(0.0, room));
  for (float& r : outer) r += static_cast<float>(by);
  for (float& r : inner) r += static_cast<float>(by);
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
  Work done;
  done.outer = face_of(clay, patch, true);
  if (!(done.outer.area > 0.0)) return {};
  const double wall = done.outer.wall;
  const double stress = def.yield_stress * strength_at(work, patch);
  const double held = std::clamp(blow.held, 0.0, 1.0);

  // Against an anvil: the mean pressure on a disc between two rough plates. Paddle and anvil go in
  // with the same force, so each face has half of the work.
  const double face = std::sqrt(patch.across * patch.up);
  const double pressure = stress * (1.0 + 2.0 * face / (3.0 * std::sqrt(3.0) * wall));
  if (held > 0.0) {
    done.squeezes = true;
    done.inner = face_of(clay, patch, false);
    for (Face* each : {&done.outer, &done.inner})
      go_in(clay, patch, 0.5 * held * def.energy / pressure, *each);
  }
  // Without one: the load at which a clamped plate folds, as in wall_bears(). The hand stops the
  // paddle after a wall's thickness at the latest.
  const double load = portable::kPi * stress * wall * wall;
  done.moved = std::min((1.0 - held) * def.energy / load, wall);

  double thinner = 0.0, faces = 0.0;
  for (int j = patch.first; j < patch.end; ++j) {
    const double thins = press_row(clay, patch, j, done);
    thinner += thins * clay.row_thickness(j);
    faces += under_face(clay, patch, j) * clay.row_thickness(j);
    if (work.building != nullptr) work.building->beat(clay.stored(j), thins);
  }
  // Clay that leaves from between paddle and anvil goes round and up alike. So half of what the
  // rings got thinner makes them wider, and Volume makes them higher by the other half. Rings hold
  // each other, so those under the face widen together: one that stood out and was beaten flat does
  // not stand out farther.
  for (int j = patch.first; j < patch.end; ++j) {
    widen_row(clay, j, 0.5 * thinner / faces * under_face(clay, patch, j));
    was_struck(clay, j);
  }
  const double way = blow.side == WallSide::outside ? 1.0 : -1.0;
  return {held * pressure * done.outer.area + (1.0 - held) * load,
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
