#include "engine/effects/volume.h"

#include <algorithm>
#include <cmath>

#include "engine/effects/row_kernels.h"

namespace onggi::effects {
namespace {

// A pressed rim carries a tenth of all rows down.
constexpr double kElementsPerSecond = 16384e3;
constexpr double kLongestWait = 0.1;  // s, of any row on any grid

// Of `volume`, what went with `cut` of a row's area, of which `left` is there now, where the row is
// `thick`. Two edges that push a wall at its thinnest to and fro in one tick cut more than there
// was at once: then it is a share of what came under them.
double cut_off(double volume, double cut, double left, double thick) {
  const double gone = cut * thick;
  return gone < 0.5 * volume ? gone : volume * cut / (left + cut);
}

}  // namespace

Volume::Volume(Clay& clay) {
  clay.keep_areas();
  for (int j = 0; j < clay.rows(); ++j) {
    volume_.push_back(clay.areas()->of(j) * clay.row_thickness(j));
    thickness_.push_back(clay.row_thickness(j));
  }
}

bool Volume::pressed_down(const Clay& clay, int j) const noexcept {
  return clay.row_thickness(j) < thickness_[static_cast<std::size_t>(j)];
}

// The work list is the areas' set of changed rows, taken from the foot up. A row that lost area
// gets higher at once: a division. One that was pressed down must be reshaped, element by element,
// and a pressed rim brings a tenth of all rows: those beyond a call's budget stay on the list.
void Volume::keep(Clay& clay, double seconds) noexcept {
  RowAreas& areas = *clay.areas();
  const int most_widened = static_cast<int>(std::ceil(
      seconds * std::max(kElementsPerSecond / clay.stride(), clay.rows() / kLongestWait)));
  int lowest = -1;
  int changed = 0;
  int widened = 0;
  int waiting = 0;
  int stopped = 0;
  for (int j = areas.take_changed(0); j >= 0; j = areas.take_changed(j + 1)) {
    const auto n = static_cast<std::size_t>(j);
    // Contact sums what it took in floats, and the errors add up: 5e-9 of a row after 37 s of
    // collaring, 400 x 360. So that an hour's are no more, one row in 64 is measured, each in its
    // turn; and a row that was turned over, at once.
    if ((static_cast<unsigned>(changed++) + turn_) % 64 == 0 || areas.drifted(j))
      areas.set(j, clay.measured_area(j));
    if (lowest < 0) lowest = j;
    double area = known_area(clay, j);
    const double now = clay.row_thickness(j);
    volume_[n] -= cut_off(volume_[n], areas.take_cut(j), area, now);
    if (pressed_down(clay, j)) {
      // Those below widen_from_ had their turn in the call before: began each call at the foot, a
      // rim that is pressed all the time would be waited for for ever.
      if (j < widen_from_ || widened == most_widened) {
        if (widened == most_widened && stopped == 0) stopped = j;
        ++waiting;
        continue;
      }
      // Pressed together, a ring becomes wider and its wall thicker, alike; one that got larger
      // otherwise meanwhile gives its height for that.
      const double wider = std::sqrt(volume_[n] / (area * now));
      if (wider > 1.0) area *= reshape_row(clay, j, wider, wider);
      ++widened;
    }
    thickness_[n] = volume_[n] / area;
    clay.set_row_thickness(j, thickness_[n]);
  }
  if (lowest < 0) return;
  ++turn_;
  widen_from_ = stopped;
  // Setting the heights put these rows on the list again: it is cleared, and those that wait are
  // put back. They are known by their thickness, so that no second set is kept.
  for (int j = areas.take_changed(lowest); j >= 0; j = areas.take_changed(j + 1)) {
  }
  for (int j = lowest; waiting > 0 && j < clay.rows(); ++j) {
    if (!pressed_down(clay, j)) continue;
    areas.mark(j);
    --waiting;
  }
  // Once, however many rows changed: all above the lowest move.
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
  for (int j = clay.areas()->take_changed(0); j >= 0; j = clay.areas()->take_changed(j + 1)) {
  }
  return true;
}

void Volume::give(Clay& clay, int j, int to, double volume) noexcept {
  volume_[static_cast<std::size_t>(j)] -= volume;
  volume_[static_cast<std::size_t>(to)] += volume;
  clay.areas()->mark(j);
  clay.areas()->mark(to);
}

void Volume::add_to(StateHash& hash, Clay& clay) const {
  for (std::size_t j = 0; j < volume_.size(); ++j) {
    hash.add(volume_[j]);
    hash.add(clay.areas()->of(static_cast<int>(j)));
  }
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
  if (j < clay.floor_rows()) girth = thickness = std::sqrt(more);
  float* outer = clay.pressable_outer(j).data();
  float* inner = clay.pressable_inner(j).data();
  const row_kernels::Table& kernels = row_kernels::of(clay.vectors());
  const row_kernels::WallBounds now = kernels.bounds(clay.stride(), outer, inner);
  const double farthest = double{now.farthest};
  const double thinnest = double{now.thinnest};
  if (thickness < 1.0 && thickness * thinnest < def.wall_min) {
    thickness = std::min(def.wall_min / thinnest, 1.0);
    girth = more / thickness;
  }
  if (farthest * std::max(girth, thickness) > def.radius_max)
    girth = thickness = std::clamp(def.radius_max / farthest, 1.0, std::sqrt(more));
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
