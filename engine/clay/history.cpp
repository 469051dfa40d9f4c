#include "engine/clay/history.h"

#include <algorithm>

namespace onggi::clay {
namespace {

constexpr int kElementsATick = 2048;  // a fifth of what a tick may cost
constexpr int kLeastRowsATick = 2;
constexpr std::size_t kPlaceChanges = 16384;  // of rows: a minute of the busiest

// Rows may come from some ticks after the step's edge, with a floor that gave way there. So the
// floor is as high as the rows say. Above the floor no row reaches the axis.
int solid_rows(const Clay& clay) {
  int solid = 0;
  while (solid < clay.rows() && clay.inner(solid)[0] == 0.0f) ++solid;
  return solid;
}

}  // namespace

History::History(Clay& clay) : stride_(clay.stride()), sectors_(clay.sectors()) {
  const auto rows = static_cast<std::size_t>(clay.room());
  const std::size_t floats = 2 * static_cast<std::size_t>(stride_);
  const std::size_t slots = std::max(kBytes / (floats * sizeof(float)), rows + rows / 8);
  shadow_.resize(rows * floats);
  shadow_thickness_.resize(rows);
  ring_ = std::make_unique_for_overwrite<float[]>(slots * floats);
  slots_.resize(slots);
  if (clay.spare_rows() > 0) places_.resize(std::max(kPlaceChanges, 2 * rows));
  in_step_ = unsettled_ = RowSet(clay.room());
  for (int j = 0; j < clay.rows(); ++j) settle(clay, clay.stored(j));
  while (clay.take_change() >= 0) {
  }
  steps_.reserve(kMostSteps);
  steps_.push_back({0, 0, clay.floor_top()});
}

float* History::shadow_row(int stored) {
  return shadow_.data() + static_cast<std::size_t>(stored) * 2 * static_cast<std::size_t>(stride_);
}

float* History::ring_row(std::uint64_t at) {
  return ring_.get() + (at % slots_.size()) * 2 * static_cast<std::size_t>(stride_);
}

void History::settle(const Clay& clay, int stored) noexcept {
  std::copy_n(clay.stored_outer(stored), sectors_, shadow_row(stored));
  std::copy_n(clay.stored_inner(stored), sectors_, shadow_row(stored) + stride_);
  const int j = clay.place_of(stored);
  if (j != RowOrder::kSpare)
    shadow_thickness_[static_cast<std::size_t>(stored)] = clay.row_thickness(j);
}

void History::remember(int stored) noexcept {
  std::copy_n(shadow_row(stored), 2 * stride_, ring_row(next_));
  slots_[next_ % slots_.size()] = {stored, shadow_thickness_[static_cast<std::size_t>(stored)]};
  in_step_.add(stored);
  ++next_;
}

void History::keep_row(Clay& clay, int stored) noexcept {
  // If the step before is not settled yet, half of it would count with this one.
  if (unsettled_.has(stored)) {
    unsettled_.remove(stored);
    clay.forget_change(stored);
    settle(clay, stored);
  }
  if (!in_step_.has(stored)) remember(stored);
}

void History::note(PlaceChange change) noexcept {
  places_[next_place_ % places_.size()] = change;
  ++next_place_;
}

// The last `most` row insertions and removals of the step that is taken back, the last one first.
void History::undo_places(Clay& clay, int most) noexcept {
  for (; most > 0 && next_place_ > steps_.back().first_place; --most) {
    const PlaceChange& change = places_[--next_place_ % places_.size()];
    if (change.inserted)
      clay.erase_row(change.place);
    else
      clay.insert_row(change.place, change.solid);
    lowest_ = 0;
  }
}

// True once nothing is left to do.
bool History::keep_up(Clay& clay, int rows) noexcept {
  for (; rows > 0; --rows) {
    const int j = unsettled_.take();
    if (j < 0) break;
    clay.forget_change(j);  // changes after the step's end count with it
    settle(clay, j);
  }
  int from = 0;
  while (rows > 0) {
    const int j = clay.take_change(from);
    if (j < 0) return true;
    from = j;
    if (in_step_.has(j)) continue;
    remember(j);
    --rows;
  }
  return false;
}

// The touch and what settled before it are one step: its edge is then the undo, to the last bit.
void History::begin_touch() noexcept {
  if (!settling_) return;
  settling_ = steps_.back().settles = false;
  lasted_ = 0.0;
}

void History::follow(Clay& clay, Stir stir, double seconds) noexcept {
  if (stir == Stir::touching) begin_touch();
  if (stir == Stir::moving) steps_.back().moves = true;
  keep_up(clay, std::max(kLeastRowsATick, rows_of(kElementsATick)));
  clear_ = stir == Stir::none ? clear_ + seconds : 0.0;
  const bool empty = steps_.back().first == next_;
  lasted_ = empty ? 0.0 : lasted_ + seconds;
  // Clay that settles is one step, however long: nobody takes back a part of it.
  if (!empty && !settling_ && (clear_ >= kPause || lasted_ >= kLongest)) end_step(clay);
}

void History::end_step(const Clay& clay) noexcept {
  lasted_ = 0.0;
  if (steps_.back().first == next_) return;
  unsettled_.add(in_step_);
  in_step_.clear();
  if (steps_.size() == kMostSteps) steps_.erase(steps_.begin());
  steps_.push_back({next_, next_place_, clay.floor_top(), settling_, false});
  ++depth_;
}

bool History::begin_step(Clay& clay, int element_budget) noexcept {
  if (!keep_up(clay, rows_of(element_budget))) return false;
  const bool empty = steps_.back().first == next_;
  settling_ = false;
  if (empty) steps_.back().settles = false;
  end_step(clay);
  return empty;
}

bool History::reaches_back_to(bool moved_by_itself) const {
  std::uint64_t end = next_;
  for (std::size_t n = steps_.size(); n-- > 0 && reaches(steps_[n]); end = steps_[n].first)
    if (steps_[n].first != end && (!steps_[n].settles || (moved_by_itself && steps_[n].moves)))
      return true;
  return false;
}

bool History::can_step_back() const { return reaches_back_to(true); }

void History::put_back(Clay& clay, std::uint64_t at) noexcept {
  const Slot& slot = slots_[at % slots_.size()];
  const float* kept = ring_row(at);
  std::copy_n(kept, sectors_, clay.stored_outer(slot.row));
  std::copy_n(kept + stride_, sectors_, clay.stored_inner(slot.row));
  const int j = clay.place_of(slot.row);
  if (j != RowOrder::kSpare) {
    clay.forget_row(j);
    if (slot.thickness != clay.row_thickness(j)) {
      clay.set_row_thickness(j, slot.thickness);
      lowest_ = std::min(lowest_, j);
    }
    clay.mark_dirty(j);
  }
  settle(clay, slot.row);
}

bool History::step_back_some(Clay& clay, int element_budget) noexcept {
  int rows = rows_of(element_budget);
  if (!going_back_) {
    if (!keep_up(clay, rows)) return false;
    if (!can_step_back()) return true;
    if (steps_.back().first == next_) {
      steps_.pop_back();
      --depth_;
    }
    lowest_ = clay.room();
    going_back_ = true;
    return false;
  }
  if (next_place_ > steps_.back().first_place) {
    clay.forget_displacements();
    undo_places(clay, std::max(1, element_budget / clay.room()));
    return false;
  }
  for (; rows > 0 && next_ > steps_.back().first; --rows) put_back(clay, --next_);
  if (next_ > steps_.back().first) return false;
  // Restacking would move the floor: it is set again afterwards.
  if (lowest_ < clay.rows()) clay.restack(lowest_);  // room(): no row
  clay.set_floor(solid_rows(clay), steps_.back().floor_top);
  while (clay.take_change(0) >= 0) {
  }
  in_step_.clear();
  going_back_ = false;
  lasted_ = 0.0;
  const bool settled = steps_.back().settles;
  settling_ = steps_.back().settles = true;  // what moves now belongs to no hand
  steps_.back().moves = false;
  // Else clay that sags again and again could never be taken back any further.
  return !settled || !reaches_back_to(false);
}

void History::add_to(StateHash& hash) const {
  hash.add(next_);
  hash.add(static_cast<std::uint64_t>(steps_.size()));
  hash.add(steps_.back().first);
  hash.add(static_cast<std::uint64_t>(going_back_));
  if (next_place_ > 0) hash.add(next_place_);
  for (std::size_t n = 0; n < steps_.size(); ++n)
    if (steps_[n].settles &&
        steps_[n].first != (n + 1 < steps_.size() ? steps_[n + 1].first : next_))
      hash.add(steps_[n].first);
}

}  // namespace onggi::clay
