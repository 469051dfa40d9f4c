#include "engine/effects/building.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/effect_list.h"
#include "engine/effects/volume.h"
#include "engine/math/portable.h"

namespace onggi {

std::span<const DefField<BuildingDef>> BuildingDef::fields() {
  static constexpr DefField<BuildingDef> kFields[] = {
      {"coil", &BuildingDef::coil, 0.008, 0.03, "m"},
      {"tallest", &BuildingDef::tallest, 0.05, 1.0, "m"},
      {"pace", &BuildingDef::pace, 0.02, 5.0, "m/s"},
      {"drift", &BuildingDef::drift, 0.0, 0.25, "coils"},
      {"joint", &BuildingDef::joint, 0.05, 1.0, ""},
      {"pinched", &BuildingDef::pinched, 0.0, 1.0, ""},
      {"wetness", &BuildingDef::wetness, 0.0, 1.0, ""},
  };
  return kFields;
}

namespace effects {
namespace {

constexpr double kCut = 0.8;        // share of the coil's radius left above and below its
                                    // middle, where it is pressed on the ring below
constexpr double kLeans = 0.2;      // coils: the farthest that a hand lays beside the wall
constexpr double kRests = 0.25;     // coils: the least that lies on the wall
constexpr double kUpright = 0.3;    // of `out`: the coil lies on the rim, not beside it
constexpr double kJoint = 0.002;    // m: height of the weak band above a joint. An estimate
constexpr double kWorked = 0.0005;  // m: moves that leave 1/e of a joint as it was. An estimate
constexpr double kBeaten = 0.05;    // thinned by so much, 1/e of a joint is as it was. An estimate

double section_of(const BuildingDef& def) { return 0.25 * portable::kPi * def.coil * def.coil; }

// Width of the ring's wall in slice `k` of `slices` of equal height, m.
double width(const BuildingDef& def, const ClayDef& clay, int k, int slices) {
  const double up = kCut * ((2 * k + 1.0) / slices - 1.0);
  return std::max(def.coil * std::sqrt(1.0 - up * up), clay.wall_min * (1.0 + 1e-6));
}
double widths(const BuildingDef& def, const ClayDef& clay, int slices) {
  double sum = 0.0;
  for (int k = 0; k < slices; ++k) sum += width(def, clay, k, slices);
  return sum;
}

// As many rows as the ring's height has at a fresh lump's thickness.
int slices_of(const BuildingDef& def, const ClayDef& clay) {
  const double rows = Building::ring_height(def, clay) * clay.rows / clay.height;
  return std::max(1, static_cast<int>(std::lround(rows)));
}

}  // namespace

// As many rings as there may be rows for.
Building::Building(const BuildingDef& def, const Clay& clay)
    : laid_(clay.sectors(),
            static_cast<std::size_t>(clay.room() / slices_of(def, clay.def()) + 1) *
                static_cast<std::size_t>(clay.sectors() + slices_of(def, clay.def()))),
      rings_(static_cast<std::size_t>(clay.room())),
      slices_(slices_of(def, clay.def())),
      height_(ring_height(def, clay.def())),
      widths_(widths(def, clay.def(), slices_)) {}

Building Building::make(const Effects& def, Clay& clay) { return {*def.building, clay}; }

bool Building::wanted(const Effects& def) { return def.building.has_value(); }

double Building::ring_height(const BuildingDef& def, const ClayDef& clay) {
  constexpr int kSlices = 64;
  return section_of(def) * kSlices / widths(def, clay, kSlices);
}

int Building::spare_rows(const BuildingDef& def, const ClayDef& clay) {
  return static_cast<int>(std::ceil(std::max(def.tallest / clay.height, 1.0) * clay.rows));
}

bool Building::has_room(const BuildingDef& def, const Clay& clay) const noexcept {
  const ClayDef& lump = clay.def();
  const double wide = 1.01 * std::max(def.coil, lump.wall_min);
  return lump.radius_min + wide < lump.radius_max && clay.rim_height() + height_ <= def.tallest &&
         clay.spare_rows() >= slices_ &&
         !laid_.full(static_cast<std::size_t>(clay.sectors() + slices_));
}

// A coil lies where the hand lays it, but always on the wall.
double Building::centre_under(const BuildingDef& def, const Clay& clay, int sector,
                              Vec3 at) const noexcept {
  const auto i = static_cast<std::size_t>(sector);
  const int top = clay.rows() - 1;
  const double outer = double{clay.outer(top)[i]}, inner = double{clay.inner(top)[i]};
  const double middle = 0.5 * (outer + inner);
  const double in = std::min(middle, inner + kRests * def.coil) - kLeans * def.coil;
  const double out = std::max(middle, outer - kRests * def.coil) + kLeans * def.coil;
  const double half = 0.5 * std::max(def.coil, clay.def().wall_min);
  const double wanted = std::clamp(length(Vec2{at.x, at.z}), in, out) + def.drift * def.coil;
  const double least = clay.def().radius_min + 1.001 * half;
  return std::clamp(wanted, least, std::max(least, clay.def().radius_max - 1.001 * half));
}

bool Building::lay(const BuildingDef& def, Clay& clay, Vec3 from, Vec3 to, double seconds,
                   std::uint64_t step) noexcept {
  const Overlap rim = rim_touched(clay, to, 0.5 * def.coil);
  const bool rests = rim.depth > 0.0 && rim.out.y > kUpright && to.y > clay.rim_height();
  if (!rests || rises()) return rests;
  if (!laid_.any() && !has_room(def, clay)) return rests;

  const int n = clay.sectors();
  const int first = sector_at(clay, from), last = sector_at(clay, to);
  const int ahead = (last - first + n) % n;
  const int way = 2 * ahead <= n ? 1 : -1;  // the short way round
  const int passed = way > 0 ? ahead : n - ahead;
  // Near the axis a hand passes many sectors in no time. The coil does not.
  const double sector = 2.0 * portable::kPi / n * centre_under(def, clay, last, to);
  const double gone = std::max(length(to - from), (passed - 1) * sector);
  if (gone > def.pace * seconds) return rests;
  bool more = false;
  for (int k = 0; k <= passed; ++k) {
    const int here = (first + way * k + n) % n;
    if (laid_.centre(here) != 0.0f) continue;
    const double share = passed > 0 ? 1.0 * k / passed : 1.0;
    const Vec3 there = from + share * (to - from);
    laid_.lay(here, static_cast<float>(centre_under(def, clay, here, there)), step);
    more = true;
  }
  if (!more) return rests;
  laid_.close_gaps(def.coil, step);
  clay.mark_dirty(clay.rows() - 1);  // so that undo and drawing see it
  return rests;
}

// The slices share the coil's clay by their widths, so that the ring has all of it to a double's
// rounding, and each gets as high as its measured area asks.
RowAdded Building::raise(const BuildingDef& def, Clay& clay, std::uint64_t step) noexcept {
  const int k = laid_.raised();
  const double wide = width(def, clay.def(), k, slices_);
  const double volume = laid_.volume(section_of(def)) * wide / widths_;
  const int j = clay.rows();
  const RowAdded added{j, clay.next_spare(), volume};
  clay.insert_row(j, false);
  for (const bool inside : {false, true})
    if (Displacements* moved = clay.displacements(inside); moved != nullptr)
      std::fill_n(moved->row(added.to), clay.stride(), 0.0f);
  const std::span<float> outer = clay.pressable_outer(j);
  const std::span<float> inner = clay.pressable_inner(j);
  const double half = 0.5 * wide;
  double squares = 0.0;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    const auto centre = double{laid_.centre(static_cast<int>(i))};
    outer[i] = static_cast<float>(centre + half);
    inner[i] = static_cast<float>(centre - half);
    squares += 2.0 * (centre * centre + half * half);
  }
  clay.set_extent(j, *std::ranges::max_element(outer), *std::ranges::min_element(inner));
  clay.areas()->set(j, clay.measured_area(j));
  clay.set_row_thickness(j, volume / clay.areas()->of(j));
  clay.mark_dirty(j);
  const bool joint = k == 0 || (k + 0.5) * height_ < kJoint * slices_;
  const double square = squares / clay.sectors();
  rings_[static_cast<std::size_t>(added.to)] = {joint, square, {}, 0.0f};
  laid_.raise({added.to, joint, volume, square}, k + 1 == slices_, step);
  return added;
}

void Building::run(const StageWork& work) noexcept {
  Clay& clay = work.clay;
  const bool inside = work.side == WallSide::inside;
  Displacements& moved = *clay.displacements(inside);
  for (int j = moved.first_row(); j < moved.end_row(); ++j) {
    Ring& ring = rings_[static_cast<std::size_t>(clay.stored(j))];
    if (!ring.joint) continue;
    const float* const row = moved.row(clay.stored(j));
    float sum = 0.0f;
    for (BlockRun run = moved.run_from(0); run.any(); run = moved.run_from(run.end))
      for (int i = run.begin * Displacements::kBlock; i < run.end * Displacements::kBlock; ++i)
        sum += row[i];
    ring.worked[inside ? 1 : 0] += sum / static_cast<float>(clay.sectors());
  }
}

void Building::beat(int stored, double thinner) noexcept {
  Ring& ring = rings_[static_cast<std::size_t>(stored)];
  if (ring.joint) ring.beaten += static_cast<float>(thinner);
}

double Building::strength(const BuildingDef& def, int stored) const noexcept {
  if (!of(stored).joint) return 1.0;
  double worked = 0.0;
  for (const float face : of(stored).worked)
    worked -= 0.5 * portable::expm1(-double{face} / kWorked);
  const double beaten = -portable::expm1(-double{of(stored).beaten} / kBeaten);
  return def.joint + std::max(worked * def.pinched, beaten) * (1.0 - def.joint);
}

// The lower half stays the joint.
void Building::row_divided(const Clay&, const RowDivided& divided) noexcept {
  rings_[static_cast<std::size_t>(divided.to)] = {false, of(divided.from).square, {}, 0.0f};
}

// Work that is taken back stays with its stored row, until another ring takes that row.
void Building::forget(Clay& clay, const Laid& laid) noexcept {
  if (laid.fresh) {
    laid_.clear(laid.step);
    for (const int row : clay.stored()) rings_[static_cast<std::size_t>(row)] = {};
    return;
  }
  laid_.go_back(laid.step);
  for (int row = 0; row < clay.room(); ++row)
    if (clay.place_of(row) == RowOrder::kSpare) rings_[static_cast<std::size_t>(row)] = {};
  laid_.each_row([this](const LaidCoil::Row& row) {
    Ring& ring = rings_[static_cast<std::size_t>(row.stored)];
    ring.joint = row.joint;
    ring.square = row.square;
  });
}

void Building::add_to(StateHash& hash, const Clay& clay) const {
  laid_.add_to(hash);
  for (int j = 0; j < clay.rows(); ++j) {
    const Ring& ring = of(clay.stored(j));
    if (!ring.joint) continue;
    hash.add(static_cast<std::uint64_t>(j));
    for (const float face : ring.worked) hash.add(double{face});
    if (ring.beaten > 0.0f) hash.add(double{ring.beaten});
  }
}

}  // namespace effects
}  // namespace onggi
