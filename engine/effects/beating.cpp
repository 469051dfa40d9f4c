#include "engine/effects/beating.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/effect_list.h"
#include "engine/effects/prints.h"
#include "engine/effects/row_kernels.h"
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

using Looked = Beating::Looked;

constexpr double kFarthest =
    0.03;  // m between ball and wall: a blow from farther away hits nothing
constexpr double kMostThinner = 0.25;  // of the wall, in a blow
constexpr double kNear = 1e-5;         // of the work: Newton's steps end

// A paddle's face gives way round its edge. So a blow has no ridge there.
double face_at(double square) { return square < 1.0 ? (1.0 - square) * (1.0 - square) : 0.0; }

// Where a blow lands. The wall is taken to be upright: on a wall that leans, the face is as high as
// its shadow on an upright one.
struct Patch {
  double radius = 0.0;  // m, of the face that is struck, in the middle
  double across = 0.0;  // m, half the patch round the ring: at most the radius, on a thin neck
  double up = 0.0;      // m, half its height
  double x = 0.0, z = 0.0, y = 0.0;   // its middle: a unit vector, and m
  int first = 0, end = 0;             // rows,
  int first_sector = 0, sectors = 0;  // and sectors, onwards round the ring
};

// Where an element lies under the face.
struct OnFace {
  double weight, round, up;
};
OnFace on_face(const Clay& clay, const Patch& patch, int j, std::size_t i) {
  const double up = (clay.row_height(j) - patch.y) / patch.up;
  const double dx = double{clay.ray_cos()[i]} - patch.x, dz = double{clay.ray_sin()[i]} - patch.z;
  const double scale = patch.radius / patch.across;
  return {face_at(up * up + (dx * dx + dz * dz) * scale * scale),
          (dz * patch.x - dx * patch.z) * scale, up};
}
std::size_t sector_of(const Clay& clay, const Patch& patch, int k) {
  return static_cast<std::size_t>((patch.first_sector + k) % clay.sectors());
}

// Nothing gives way in a torn row, which tools pass through, and in one that may get no higher.
bool gives(const Clay& clay, int j) { return !clay.areas()->torn(j) && !clay.areas()->rigid(j); }

// Where `blow` meets the wall; no rows if it misses.
Patch patch_of(const BeatingDef& def, const Clay& clay, const Blow& blow) {
  Patch patch;
  if (clay.floor_rows() >= clay.rows()) return patch;  // a solid lump has no wall
  const double out = length(Vec2{blow.at.x, blow.at.z});
  const int j = std::clamp(clay.first_row_above(blow.at.y), clay.floor_rows(), clay.rows() - 1);
  const int n = clay.sectors(), middle = sector_at(clay, blow.at);
  const auto i = static_cast<std::size_t>(middle);
  patch.radius = double{(blow.side == WallSide::outside ? clay.outer(j) : clay.inner(j))[i]};
  if (std::fabs(out - patch.radius) > kFarthest + blow.ball || !(out > 0.0 && patch.radius > 0.0))
    return patch;
  // On coarse grids the face has an element, at least.
  const double sector = 2.0 * portable::kPi / n;
  patch.across = std::max(std::min(def.face, patch.radius), sector * patch.radius);
  patch.up = std::max(def.face, clay.row_thickness(j));
  patch.x = blow.at.x / out;
  patch.z = blow.at.z / out;
  patch.y = blow.at.y;
  patch.first = std::max(clay.first_row_above(patch.y - patch.up), clay.floor_rows());
  patch.end = std::max(clay.first_row_above(patch.y + patch.up), patch.first);
  // The chord is no longer than `across`, so the arc is at most pi / 3 of it.
  const int half =
      static_cast<int>(std::ceil(portable::kPi / 3.0 * patch.across / patch.radius / sector)) + 1;
  patch.sectors = std::min(2 * half + 1, n);
  patch.first_sector = (middle - std::min(half, n / 2) + n) % n;
  return patch;
}

// The elements over which the balance is struck, at most as many as `into` has room for.
std::span<const Looked> look(const Clay& clay, const Patch& patch, std::span<Looked> into) {
  int by_row = 1, by_sector = 1;
  const auto count = [&] {
    const int rows = (patch.end - patch.first + by_row - 1) / by_row;
    return static_cast<std::size_t>(rows) *
           static_cast<std::size_t>((patch.sectors + by_sector - 1) / by_sector);
  };
  while (count() > into.size())
    (patch.end - patch.first) / by_row > patch.sectors / by_sector ? ++by_row : ++by_sector;
  const double wide = patch.radius * 2.0 * portable::kPi / clay.sectors();
  std::size_t n = 0;
  for (int j = patch.first + by_row / 2; j < patch.end; j += by_row) {
    if (!gives(clay, j)) continue;
    const double area = wide * clay.row_thickness(j) * by_row * by_sector;
    for (int k = by_sector / 2; k < patch.sectors; k += by_sector) {
      const std::size_t i = sector_of(clay, patch, k);
      const OnFace at = on_face(clay, patch, j, i);
      if (at.weight > 0.0)
        into[n++] = {static_cast<float>(at.weight),
                     static_cast<float>(at.round),
                     static_cast<float>(at.up),
                     clay.outer(j)[i],
                     clay.inner(j)[i],
                     static_cast<float>(area)};
    }
  }
  return into.first(n);
}

// A face of the wall under the paddle, or under the anvil.
struct Face {
  bool outside = true;
  // The plane on which the tool comes to lie: radius = mean + by_round (..) + by_up (..), m.
  double mean = 0.0, by_round = 0.0, by_up = 0.0;
  double round = 0.0, up = 0.0;  // the weights' middle
  double deep = 0.0;  // m: how far beyond it the tool goes in; less than 0: only on what stands out

  // How far an element stands out of the plane, m.
  double proud(double radius, double at_round, double at_up) const {
    const double even = mean + by_round * (at_round - round) + by_up * (at_up - up);
    return outside ? radius - even : even - radius;
  }
  // How far the tool goes into it, m.
  double into(double radius, const OnFace& at) const {
    return std::max(0.0, at.weight * (deep + proud(radius, at.round, at.up)));
  }
};
double radius_of(const Looked& each, bool outside) {
  return double{outside ? each.outer : each.inner};
}

// Least squares of the radii, by weight. The two slopes are found one by one: in a patch that rim
// or floor cuts off they are a little off, and the plane with them.
Face face_of(std::span<const Looked> looked, bool outside) {
  Face face;
  face.outside = outside;
  double sum = 0.0;
  for (const Looked& each : looked) {
    const double by = double{each.weight} * double{each.area};
    sum += by;
    face.mean += by * radius_of(each, outside);
    face.round += by * double{each.round};
    face.up += by * double{each.up};
  }
  face.mean /= sum, face.round /= sum, face.up /= sum;
  double rounds = 0.0, ups = 0.0;
  for (const Looked& each : looked) {
    const double by = double{each.weight} * double{each.area};
    const double round = double{each.round} - face.round, up = double{each.up} - face.up;
    const double off = radius_of(each, outside) - face.mean;
    rounds += by * round * round;
    ups += by * up * up;
    face.by_round += by * round * off;
    face.by_up += by * up * off;
  }
  face.by_round = rounds > 0.0 ? face.by_round / rounds : 0.0;
  face.by_up = ups > 0.0 ? face.by_up / ups : 0.0;
  return face;
}

// How deep the tool goes in for `work` / pressure (m^3): the sum of x + x^2 / wall over the area,
// with x of Face::into(). That is Y ln(wall / (wall - 2 x)) to second order, of which each face has
// a half. The sum is convex and rises with the depth, so Newton's steps from above fall to the
// root. Returns the area that was pressed, by weight, m^2.
double go_in(std::span<const Looked> looked, double work, Face& face) {
  double most = 0.0, all = 0.0;
  for (const Looked& each : looked) {
    const double off =
        face.proud(radius_of(each, face.outside), double{each.round}, double{each.up});
    most = std::max(most, std::fabs(off));
    all += double{each.weight} * double{each.area};
  }
  constexpr int kSteps = 12;  // 4 are enough on an even wall, 8 on a ridged one
  face.deep = most + work / all;
  double pressed = all;
  for (int step = 0; step < kSteps; ++step) {
    double sum = 0.0, slope = 0.0;
    pressed = 0.0;
    for (const Looked& each : looked) {
      const double x = face.into(radius_of(each, face.outside),
                                 {double{each.weight}, double{each.round}, double{each.up}});
      if (x == 0.0) continue;
      const double area = double{each.area}, wall = double{each.outer} - double{each.inner};
      sum += (x + x * x / wall) * area;
      slope += double{each.weight} * (1.0 + 2.0 * x / wall) * area;
      pressed += double{each.weight} * area;
    }
    if (!(slope > 0.0) || sum - work <= kNear * work) break;
    face.deep -= (sum - work) / slope;
  }
  return pressed;
}

// What a blow does to the patch.
struct Work {
  bool from_outside = true;
  bool squeezes = false;
  Face outer, inner;    // only if it squeezes
  bool inwards = true;  // the wall moves so,
  double moved = 0.0;   // m, in the middle
};

// What became of a row.
struct Pressed {
  double thinner = 0.0;  // mean of ln(wall before / wall after) over the ring, to second order:
                         // 3e-4 too little where a blow takes a tenth of the wall
  float under = 0.0f;    // how much of the ring lies under the face, 0..1
};
Pressed press_row(Clay& clay, const Patch& patch, int j, const Work& work) {
  const ClayDef& lump = clay.def();
  const double least = lump.wall_min * (1.0 + 1e-6);
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  double sum = 0.0, under = 0.0;
  for (int k = 0; k < patch.sectors; ++k) {
    const std::size_t i = sector_of(clay, patch, k);
    const OnFace at = on_face(clay, patch, j, i);
    if (at.weight == 0.0) continue;
    under += at.weight;
    const double wall = double{outer[i]} - double{inner[i]};
    const double most = std::min(std::max(wall - least, 0.0), kMostThinner * wall);
    const double out = work.squeezes ? work.outer.into(double{outer[i]}, at) : 0.0;
    const double in = work.squeezes ? work.inner.into(double{inner[i]}, at) : 0.0;
    const double share = out + in > most ? most / (out + in) : 1.0;
    const double room =
        work.inwards ? double{inner[i]} - lump.radius_min : lump.radius_max - double{outer[i]};
    const double moves = std::min(at.weight * work.moved, std::max(0.0, room));
    const double way = work.inwards ? -moves : moves;
    outer[i] = static_cast<float>(double{outer[i]} + way - share * out);
    inner[i] = static_cast<float>(double{inner[i]} + way + share * in);
    const double thins = share * (out + in) / wall;
    sum += thins * (1.0 + 0.5 * thins);
  }
  return {sum / clay.sectors(), static_cast<float>(under / clay.sectors())};
}

// Makes row `j` wider all round by `by` (m), and writes what follows from its new radii.
void widen_row(Clay& clay, int j, double by) {
  const ClayDef& lump = clay.def();
  const std::span<float> outer = clay.pressable_outer(j), inner = clay.pressable_inner(j);
  const row_kernels::Table& kernels = row_kernels::of(clay.vectors());
  const float farthest = kernels.bounds(clay.stride(), outer.data(), inner.data()).farthest;
  const double room = std::max(0.0, lump.radius_max - double{farthest});
  const auto wider = static_cast<float>(std::clamp(by, 0.0, room));
  for (float& r : outer) r += wider;
  for (float& r : inner) r += wider;
  // Changes nothing but a wall that rounding made too thin, and tells the row's extent.
  const row_kernels::FaceMoved extent = kernels.mix(
      clay.stride(), 1.0f, 0.0f, static_cast<float>(lump.wall_min), outer.data(), inner.data());
  clay.set_extent(j, extent.outermost, extent.innermost);
  clay.areas()->set(j, clay.measured_area(j));
  clay.areas()->mark(j);
  clay.mark_dirty(j);
}

// Share of its strength that water leaves the wall where the blow lands.
double strength_at(const StageWork& work, const Patch& patch) {
  if (work.tick.moisture == nullptr) return 1.0;
  return strength(*work.def.moisture, work.tick.moisture->at(work.clay, patch.y));
}

// The paddle's face leaves its print on its side, an anvil's on the other. A hand leaves none, and
// without anything behind the wall the paddle hardly goes in.
void leave_prints(const StageWork& work, const Blow& blow, const Patch& patch, double wall,
                  const Work& done) {
  if (!done.squeezes) return;
  // Where the wall is nearest to the middle of the face, and what it gives there.
  const double low = std::max(patch.y - patch.up, work.clay.floor_top());
  const double high = std::min(patch.y + patch.up, work.clay.rim_height());
  if (!(high > low)) return;
  const double off = (std::clamp(patch.y, low, high) - patch.y) / patch.up;
  const double weight = face_at(off * off);
  const double out = std::max(0.0, weight * done.outer.deep);
  const double in = std::max(0.0, weight * done.inner.deep);
  const double most = kMostThinner * wall;
  const double share = out + in > most ? most / (out + in) : 1.0;
  Print print;
  print.left = blow.left;
  print.low = patch.y - patch.up;
  print.high = patch.y + patch.up;
  print.angle = portable::atan2(patch.z, patch.x);
  print.half = 2.0 * portable::asin(std::min(1.0, 0.5 * patch.across / patch.radius));
  print.tall = patch.up;
  for (const bool outside : {true, false}) {
    const bool paddle = outside == done.from_outside;
    if (!paddle && !blow.anvil) continue;
    print.kind = paddle ? Print::paddle : Print::anvil;
    print.side = outside ? WallSide::outside : WallSide::inside;
    print.deep = share * (outside ? out : in);
    // Both faces lie under the same angle, and the inner one is shorter.
    print.wide = paddle ? patch.across
                        : patch.across * (outside ? done.outer : done.inner).mean / patch.radius;
    work.prints->strike(work, print);
  }
}

Struck strike(const StageWork& work, const Blow& blow, std::span<Looked> room,
              std::span<float> under) {
  const BeatingDef& def = *work.def.beating;
  Clay& clay = work.clay;
  const Patch patch = patch_of(def, clay, blow);
  const std::span<const Looked> looked = look(clay, patch, room);
  if (looked.empty()) return {};
  double area = 0.0, wall = 0.0;
  for (const Looked& each : looked) {
    const double by = double{each.weight} * double{each.area};
    area += by;
    wall += by * (double{each.outer} - double{each.inner});
  }
  wall /= area;
  const double stress = def.yield_stress * strength_at(work, patch);
  const double squeezes = std::clamp(blow.squeezes, 0.0, 1.0);
  const double moves = std::clamp(blow.moves, -1.0, 1.0);
  Work done;
  done.from_outside = blow.side == WallSide::outside;
  done.inwards = done.from_outside == (moves >= 0.0);

  // Against an anvil: the mean pressure on a disc between two rough plates. Paddle and anvil go in
  // with the same force, so each face has half of the work.
  const double face = std::sqrt(patch.across * patch.up);
  const double pressure = stress * (1.0 + 2.0 * face / (3.0 * std::sqrt(3.0) * wall));
  double force = 0.0;
  if (squeezes > 0.0) {
    done.squeezes = true;
    for (const bool outside : {true, false}) {
      Face& each = outside ? done.outer : done.inner;
      each = face_of(looked, outside);
      force +=
          0.5 * squeezes * pressure * go_in(looked, 0.5 * squeezes * def.energy / pressure, each);
    }
  }
  // What one of the two strikes harder moves the wall: the load at which a clamped plate folds, as
  // in wall_bears(). A hand stops after a wall's thickness at the latest.
  const double load = portable::kPi * stress * wall * wall;
  done.moved = std::min(std::fabs(moves) * def.energy / load, wall);
  force += std::fabs(moves) * load;

  double thinner = 0.0, faces = 0.0;
  for (int j = patch.first; j < patch.end; ++j) {
    if (!gives(clay, j)) continue;
    const Pressed pressed = press_row(clay, patch, j, done);
    under[static_cast<std::size_t>(j)] = pressed.under;
    thinner += pressed.thinner * clay.row_thickness(j);
    faces += double{pressed.under} * clay.row_thickness(j);
    if (work.building != nullptr) work.building->beat(clay.stored(j), pressed.thinner);
  }
  // Clay that leaves from between paddle and anvil goes round and up alike. So half of what the
  // rings got thinner makes them wider, and Volume makes them higher by the other half. Rings hold
  // each other, so those under the face widen together: one that stood out and was beaten flat does
  // not stand out farther.
  const double radius =
      0.5 * (done.from_outside ? 2.0 * patch.radius - wall : 2.0 * patch.radius + wall);
  const double wider = faces > 0.0 ? 0.5 * thinner / faces * radius : 0.0;
  for (int j = patch.first; j < patch.end; ++j)
    if (gives(clay, j)) widen_row(clay, j, wider * double{under[static_cast<std::size_t>(j)]});
  if (work.prints != nullptr) leave_prints(work, blow, patch, wall, done);
  const double way = done.from_outside ? 1.0 : -1.0;
  return {force, Vec3{way * patch.x, 0.0, way * patch.z}};
}

}  // namespace

Beating::Beating(const Clay& clay)
    : looked_(kLooked), under_(static_cast<std::size_t>(clay.room())) {}

bool Beating::wanted(const Effects& def) { return def.beating.has_value(); }

void Beating::run(const StageWork& work) noexcept {
  for (std::size_t n = 0; n < struck_.size(); ++n)
    struck_[n] =
        work.tick.blow[n].lands ? strike(work, work.tick.blow[n], looked_, under_) : Struck{};
}

Overlap wall_touched(const Clay& clay, Vec3 at, double radius) noexcept {
  if (at.y >= clay.rim_height()) return rim_touched(clay, at, radius);
  const double out = length(Vec2{at.x, at.z});
  if (clay.floor_rows() >= clay.rows() || at.y < clay.floor_top() || !(out > 0.0)) return {};
  const int above = std::clamp(clay.first_row_above(at.y), clay.floor_rows(), clay.rows() - 1);
  const int below = std::max(above - 1, clay.floor_rows());
  const double apart = clay.row_height(above) - clay.row_height(below);
  const double up =
      apart > 0.0 ? std::clamp((at.y - clay.row_height(below)) / apart, 0.0, 1.0) : 0.0;
  const auto n = static_cast<std::size_t>(clay.sectors());
  const double rays = portable::atan2(at.z, at.x) / (2.0 * portable::kPi) * clay.sectors() - 0.5;
  const double down = std::floor(rays);
  const auto i = static_cast<std::size_t>(static_cast<int>(down) + clay.sectors()) % n;
  const auto on = [&](std::span<const float> face) {
    return double{face[i]} + (rays - down) * (double{face[(i + 1) % n]} - double{face[i]});
  };
  const double outer = on(clay.outer(below)) + up * (on(clay.outer(above)) - on(clay.outer(below)));
  const double inner = on(clay.inner(below)) + up * (on(clay.inner(above)) - on(clay.inner(below)));
  const bool outside = out >= 0.5 * (outer + inner);
  const double depth = outside ? radius - (out - outer) : radius - (inner - out);
  if (!(depth > 0.0)) return {};
  const double way = outside ? 1.0 : -1.0;
  return {depth, {way * at.x / out, 0.0, way * at.z / out}};
}

bool outside_of_wall(const Clay& clay, Vec3 at) noexcept {
  const int j = std::clamp(clay.first_row_above(at.y), 0, clay.rows() - 1);
  const auto i = static_cast<std::size_t>(sector_at(clay, at));
  return length(Vec2{at.x, at.z}) >= 0.5 * (double{clay.outer(j)[i]} + double{clay.inner(j)[i]});
}

}  // namespace effects
}  // namespace onggi
