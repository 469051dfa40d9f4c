#include "engine/effects/volume.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/effect_list.h"
#include "engine/effects/row_kernels.h"
#include "engine/math/portable.h"

namespace onggi::effects {
namespace {

// A pressed rim pushes down a tenth of all rows.
constexpr double kElementsPerSecond = 16384e3;
// The most that two hands take from at once where the clay may get no higher: 256 rows of 512, 0.2
// ms.
constexpr int kElementsAtOnce = 131072;
constexpr double kLongestWait = 0.1;  // s, for any row on any grid
// Share of a limit at which clay stops yielding: low enough that a tick does not pass the limit,
// and that the press is told.
constexpr double kHeld = 0.95;
constexpr double kFirm = 0.98;      // share of kHeld
constexpr double kLittle = 1e-6;    // share of an area: a float's rounding and its sums
constexpr double kSameClay = 1e-9;  // share of the lump: rows are measured in floats
constexpr double kNeverEmpty =
    1e-3;                         // share of a row's clay that stays, because V and h are divisors
constexpr double kRaised = 1.25;  // times a fresh lump's rows: nobody asks about thinner ones

// Adds `more` area (m^2) to row `j`, every element alike: outwards as far as possible, then
// inwards. Returns the row's new area.
double thicken(Clay& clay, int j, double more) {
  const ClayDef& def = clay.def();
  const auto farthest = static_cast<float>(def.radius_max * def.radius_max);
  const auto nearest = static_cast<float>(def.radius_min * def.radius_min);
  const double wanted = clay.areas()->of(j) + more;
  constexpr int kRounds = 4;  // an element at its limit leaves its share to the others
  for (int round = 0; round < kRounds; ++round) {
    const double left = wanted - clay.areas()->of(j);
    if (left <= kLittle * wanted) break;
    const bool outwards = round < kRounds / 2;
    if (!outwards && j < clay.floor_rows()) break;
    const auto square = static_cast<float>(left / portable::kPi);
    if (outwards)
      for (float& r : clay.pressable_outer(j))
        r = std::max(r, std::sqrt(std::min(r * r + square, farthest)));
    else
      for (float& r : clay.pressable_inner(j))
        r = std::min(r, std::sqrt(std::max(r * r - square, nearest)));
    clay.areas()->set(j, clay.measured_area(j));
  }
  clay.set_extent(j, *std::ranges::max_element(clay.outer(j)),
                  *std::ranges::min_element(clay.inner(j)));
  clay.areas()->mark(j);
  clay.mark_dirty(j);
  return clay.areas()->of(j);
}

// The part of `volume` that went with the area `cut`, in a row `thick` high with the area `left`
// now. Two edges that push a wall at its thinnest to and fro in one tick cut more than was there at
// once; then the part is a share of all the clay that came under them.
double cut_off(double volume, double cut, double left, double thick) {
  const double gone = cut * thick;
  return gone < 0.5 * volume ? gone : volume * cut / (left + cut);
}

}  // namespace

Volume::Volume(Clay& clay, const Limits& limits) : limits_(limits) {
  clay.keep_areas();
  const auto room = static_cast<std::size_t>(clay.room());
  volume_.resize(room);
  thickness_.resize(room);
  raised_ = RowSet(clay.room());
  clay.areas()->keep_firm();
  for (int j = 0; j < clay.rows(); ++j) {
    const auto n = static_cast<std::size_t>(j);
    thickness_[n] = clay.row_thickness(j);
    volume_[n] = clay.areas()->of(j) * thickness_[n];
  }
  noted_.assign(kSteps, sum(clay));
}

void Volume::run(const StageWork& work) noexcept {
  keep(work.clay, work.tick.seconds, work.prints);
  if (work.prints != nullptr) work.prints->lower(work);
}

bool Volume::wanted(const Effects& def) { return def.volume.has_value(); }

// A pot that is built may get as tall as its coils.
Volume Volume::make(const Effects& def, Clay& clay) {
  Limits limits;
  if (def.building)
    limits.tallest = std::max(kTallest, def.building->tallest / clay.def().height / kHeld);
  return Volume(clay, limits);
}

bool Volume::pressed_down(const Clay& clay, int j) const noexcept {
  return clay.row_thickness(j) < thickness_[static_cast<std::size_t>(j)];
}

// Makes a ring with more clay than fits in `height` wider and its wall thicker, by the same factor.
// A ring that grew for another reason gives up height instead. Returns its area.
double Volume::widen(Clay& clay, int j, double area, double height) noexcept {
  const double volume = volume_[static_cast<std::size_t>(j)];
  const double wider = std::sqrt(volume / (area * height));
  if (wider > 1.0) area *= reshape_row(clay, j, wider, wider);
  // Already at its widest somewhere, it can only thicken elsewhere.
  const double left = volume / height - area;
  return left > kLittle * area ? thicken(clay, j, left) : area;
}

// Works through the areas' set of changed rows from the foot up. A row that lost area gets higher
// at once: one division. A row that was pressed down, or may get no higher, must be reshaped
// element by element, and a pressed rim brings a tenth of all rows. Rows beyond a call's budget
// stay on the list. No clay is lost meanwhile: a row that may get no higher still gets higher once,
// and is rigid until its turn.
void Volume::keep(Clay& clay, double seconds, Prints* prints) noexcept {
  RowAreas& areas = *clay.areas();
  const int most_widened = static_cast<int>(std::ceil(
      seconds * std::max(kElementsPerSecond / clay.stride(), clay.rows() / kLongestWait)));
  const int most_spread = (kElementsAtOnce + clay.stride() - 1) / clay.stride();
  int lowest = -1;
  int changed = 0;
  int widened = 0;
  int spread = 0;
  int waiting = 0;
  int stopped = 0;
  const double first = clay.first_thickness();
  const double thickest = kHeld * limits_.thickest * first;
  const double tallest = kHeld * limits_.tallest * clay.def().height;
  double headroom = tallest - clay.rim_height();
  for (int j = areas.take_changed(0); j >= 0; j = areas.take_changed(j + 1)) {
    const auto n = static_cast<std::size_t>(j);
    // Contact sums in floats, and the errors add up: 5e-9 of a row after 37 s of collaring, 400 x
    // 360. To stay that small over an hour, one row in 64 is measured in turn, and a row that was
    // turned over is measured at once.
    if ((static_cast<unsigned>(changed++) + turn_) % 64 == 0 || areas.drifted(j))
      areas.set(j, clay.measured_area(j));
    if (lowest < 0) lowest = j;
    double area = known_area(clay, j);
    const double now = clay.row_thickness(j);
    // Rows give and gain the same amount to the last bit, or the total would change. The exception
    // is a row that is asked for more than it has: it keeps a little that its neighbours also get.
    const double given = areas.take_given(j) * now;
    volume_[n] = std::max(volume_[n] - given, kNeverEmpty * volume_[n]);
    const double gone = cut_off(volume_[n], areas.take_cut(j), area, now);
    if (gone > 0.0 && prints != nullptr) prints->note_cut(j, gone);
    volume_[n] -= gone;
    const bool down = pressed_down(clay, j);
    const double most = down ? now : std::min(thickest, now + std::max(headroom, 0.0));
    if (down || volume_[n] / area > most) {
      // Rows below widen_from_ had their turn in the last call. If each call began at the foot, a
      // rim that is pressed all the time would wait for ever.
      if (down) {
        const bool waits = j < widen_from_ || widened == most_widened;
        if (widened == most_widened && stopped == 0) stopped = j;
        if (waits) {
          ++waiting;
          continue;
        }
        ++widened;
      }
      if (down || spread < most_spread) area = widen(clay, j, area, most);
      spread += down ? 0 : 1;
    }
    thickness_[n] = volume_[n] / area;
    headroom -= thickness_[n] - now;
    clay.set_row_thickness(j, thickness_[n]);
    if (thickness_[n] > kRaised * first) raised_.add(j);
    const bool rigid = thickness_[n] > (1.0 + kLittle) * thickest;
    waiting += rigid ? 1 : 0;
    areas.harden(j, thickness_[n] > kFirm * thickest, rigid);
  }
  areas.harden_all(headroom < (1.0 - kFirm) * tallest, headroom < (kFirm - 1.0) * tallest);
  if (lowest < 0) return;
  ++turn_;
  widen_from_ = stopped;
  // Setting the heights put these rows on the list again. Clear it, and put back those that wait.
  // Their thickness tells which they are, so no second set is kept.
  for (int j = areas.take_changed(lowest); j >= 0; j = areas.take_changed(j + 1)) {
  }
  for (int j = lowest; waiting > 0 && j < clay.rows(); ++j) {
    const bool rigid = thickness_[static_cast<std::size_t>(j)] > (1.0 + kLittle) * thickest;
    if (!pressed_down(clay, j) && !rigid) continue;
    areas.mark(j);
    --waiting;
  }
  // Once, however many rows changed: all rows above the lowest move.
  clay.restack(lowest);
}

bool Volume::measure_some(Clay& clay, int element_budget) noexcept {
  const int end = std::min(clay.rows(), measured_to_ + std::max(1, element_budget / clay.stride()));
  for (; measured_to_ < end; ++measured_to_) {
    const auto n = static_cast<std::size_t>(measured_to_);
    clay.areas()->set(measured_to_, clay.measured_area(measured_to_));
    thickness_[n] = clay.row_thickness(measured_to_);
    volume_[n] = clay.areas()->of(measured_to_) * thickness_[n];
  }
  if (measured_to_ < clay.rows()) return false;
  measured_to_ = widen_from_ = 0;
  raised_.clear();
  clay.areas()->soften();
  for (int j = clay.areas()->take_changed(0); j >= 0; j = clay.areas()->take_changed(j + 1)) {
  }
  return true;
}

double Volume::sum(const Clay& clay) const noexcept {
  double total = 0.0;
  for (int j = 0; j < clay.rows(); ++j) total += volume_[static_cast<std::size_t>(j)];
  return total;
}

void Volume::note_step(const Clay& clay, std::uint64_t step) noexcept {
  noted_[step % kSteps] = sum(clay);
}

void Volume::return_to(Clay& clay, std::uint64_t step) noexcept {
  const double share = noted_[step % kSteps] / sum(clay);
  if (std::fabs(share - 1.0) < kSameClay) return;  // then no bit changes
  for (int j = 0; j < clay.rows(); ++j) {
    volume_[static_cast<std::size_t>(j)] *= share;
    clay.areas()->mark(j);
  }
}

void Volume::give(Clay& clay, int j, int to, double volume) noexcept {
  volume_[static_cast<std::size_t>(j)] -= volume;
  volume_[static_cast<std::size_t>(to)] += volume;
  clay.areas()->mark(j);
  clay.areas()->mark(to);
}

int Volume::take_thick(const Clay& clay, double times, int from) noexcept {
  if (raised_.empty()) return -1;
  const double most = times * clay.first_thickness();
  for (const int begin : {from, 0})
    for (int j = raised_.take(begin); j >= 0; j = raised_.take(j + 1))
      if (j < clay.rows() && clay.row_thickness(j) > most) return j;
  return -1;
}

void Volume::row_added(const Clay& clay, const RowAdded& added) noexcept {
  const auto n = static_cast<std::size_t>(added.row);
  volume_[n] = added.volume;
  thickness_[n] = clay.row_thickness(added.row);
}

void Volume::row_divided(const Clay& clay, const RowDivided& divided) noexcept {
  const int j = divided.row;
  const auto n = static_cast<std::size_t>(j);
  const double lower =
      volume_[n] * clay.areas()->of(j) / (clay.areas()->of(j) + clay.areas()->of(j + 1));
  clay::open_place(volume_, j + 1, volume_[n] - lower);
  clay::open_place(thickness_, j + 1, clay.row_thickness(j + 1));
  raised_.open(j + 1);
  volume_[n] = lower;
  thickness_[n] = clay.row_thickness(j);
}

void Volume::rows_joined(const Clay& clay, const RowsJoined& joined) noexcept {
  const int j = joined.row;
  const auto n = static_cast<std::size_t>(j);
  const double both = volume_[n] + volume_[n + 1];
  clay::close_place(volume_, j + 1);
  clay::close_place(thickness_, j + 1);
  raised_.close(j + 1);
  volume_[n] = both;
  thickness_[n] = clay.row_thickness(j);
}

void Volume::add_to(StateHash& hash, Clay& clay) const {
  for (int j = 0; j < clay.rows(); ++j) {
    hash.add(of_row(j));
    hash.add(clay.areas()->of(j));
  }
  if (!raised_.empty()) raised_.add_to(hash);
  hash.add(std::uint64_t{turn_} << 32 | static_cast<std::uint64_t>(measured_to_));
  hash.add(static_cast<std::uint64_t>(widen_from_));
}

double known_area(Clay& clay, int j) noexcept {
  if (!clay.areas()->known(j)) clay.areas()->set(j, clay.measured_area(j));
  return clay.areas()->of(j);
}

double reshape_row(Clay& clay, int j, double girth, double thickness) noexcept {
  const ClayDef& def = clay.def();
  const double more = girth * thickness;
  // The smallest hole has no room for a wall that thickens inwards, so the row grows as a whole.
  // Judged by the row's extremes as if they were one element: some rows switch a little early.
  const double hole = 0.5 * ((girth + thickness) * double{clay.inner_least(j)} -
                             (thickness - girth) * double{clay.outer_most(j)});
  if (j < clay.floor_rows() || (thickness > girth && hole < def.radius_min))
    girth = thickness = std::sqrt(more);
  float* outer = clay.pressable_outer(j).data();
  float* inner = clay.pressable_inner(j).data();
  const row_kernels::Table& kernels = row_kernels::of(clay.vectors());
  // A wall that gets no thinner needs no check if its ring surely stays within its largest radius.
  const double within = double{clay.outer_most(j)};
  if (thickness < 1.0 || within * std::max(girth, thickness) > def.radius_max) {
    const row_kernels::WallBounds now = kernels.bounds(clay.stride(), outer, inner);
    const double farthest = double{now.farthest};
    const double thinnest = double{now.thinnest};
    if (thickness < 1.0 && thickness * thinnest < def.wall_min) {
      thickness = std::min(def.wall_min / thinnest, 1.0);
      girth = more / thickness;
    }
    if (farthest * std::max(girth, thickness) > def.radius_max)
      girth = thickness = std::clamp(def.radius_max / farthest, 1.0, std::sqrt(more));
  }
  // outer = middle + half, inner = middle - half.
  const auto same = static_cast<float>(0.5 * (girth + thickness));
  const auto cross = static_cast<float>(0.5 * (girth - thickness));
  const double before = clay.areas()->of(j);
  const row_kernels::FaceMoved extent =
      kernels.mix(clay.stride(), same, cross, static_cast<float>(def.wall_min), outer, inner);
  clay.set_extent(j, extent.outermost, extent.innermost);
  clay.areas()->mark(j);
  clay.areas()->set(j, clay.measured_area(j));
  clay.mark_dirty(j);
  return clay.areas()->of(j) / before;
}

}  // namespace onggi::effects
