#include "engine/clay/history.h"

#include <algorithm>

namespace onggi::clay {
namespace {

constexpr int kElementsATick = 2048;  // a fifth of what a tick may cost
constexpr int kLeastRowsATick = 2;
constexpr std::size_t kMostSteps = 256;

}  // namespace

History::History(Clay& clay) : stride_(clay.stride()), sectors_(clay.sectors()) {
  const auto rows = static_cast<std::size_t>(clay.rows());
  const std::size_t floats = 2 * static_cast<std::size_t>(stride_);
  const std::size_t slots = std::max(kBytes / (floats * sizeof(float)), rows + rows / 8);
  shadow_.resize(rows * floats);
  shadow_thickness_.resize(rows);
  ring_ = std::make_unique_for_overwrite<float[]>(slots * floats);
  slots_.resize(slots);
  in_step_ = unsettled_ = RowSet(clay.rows());
  for (int j = 0; j < clay.rows(); ++j) settle(clay, j);
  while (clay.take_change() >= 0) {
  }
  steps_.reserve(kMostSteps);
  steps_.push_back({0, clay.floor_top(), clay.floor_rows()});
}

float* History::shadow_row(int j) {
  return shadow_.data() + static_cast<std::size_t>(j) * 2 * static_cast<std::size_t>(stride_);
}

float* History::ring_row(std::uint64_t at) {
  return ring_.get() + (at % slots_.size()) * 2 * static_cast<std::size_t>(stride_);
}

void History::settle(const Clay& clay, int j) noexcept {
  std::ranges::copy(clay.outer(j), shadow_row(j));
  std::ranges::copy(clay.inner(j), shadow_row(j) + stride_);
  shadow_thickness_[static_cast<std::size_t>(j)] = clay.row_thickness(j);
}

void History::remember(int j) noexcept {
  std::copy_n(shadow_row(j), 2 * stride_, ring_row(next_));
  slots_[next_ % slots_.size()] = {j, shadow_thickness_[static_cast<std::size_t>(j)]};
  in_step_.add(j);
  ++next_;
}

// True once nothing is left to do.
bool History::keep_up(Clay& clay, int rows) noexcept {
  for (; rows > 0; --rows) {
    const int j = unsettled_.take();
    if (j < 0) break;
    clay.forget_change(j);  // what came after the step's end counts with it
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

void History::follow(Clay& clay, bool touching, double seconds) noexcept {
  keep_up(clay, std::max(kLeastRowsATick, rows_of(kElementsATick)));
  clear_ = touching ? 0.0 : clear_ + seconds;
  const bool empty = steps_.back().first == next_;
  lasted_ = empty ? 0.0 : lasted_ + seconds;
  if (!empty && (clear_ >= kPause || lasted_ >= kLongest)) end_step(clay);
}

void History::end_step(const Clay& clay) noexcept {
  lasted_ = 0.0;
  if (steps_.back().first == next_) return;
  unsettled_.add(in_step_);
  in_step_.clear();
  if (steps_.size() == kMostSteps) steps_.erase(steps_.begin());
  steps_.push_back({next_, clay.floor_top(), clay.floor_rows()});
  ++depth_;
}

bool History::begin_step(Clay& clay, int element_budget) noexcept {
  if (!keep_up(clay, rows_of(element_budget))) return false;
  if (steps_.back().first == next_) return true;
  end_step(clay);
  return false;
}

bool History::can_step_back() const {
  const Step& now = steps_.back();
  if (now.first != next_) return reaches(now);
  return steps_.size() > 1 && reaches(steps_[steps_.size() - 2]);
}

void History::put_back(Clay& clay, std::uint64_t at) noexcept {
  const Slot& slot = slots_[at % slots_.size()];
  const float* kept = ring_row(at);
  std::copy_n(kept, sectors_, clay.outer_mut(slot.row).data());
  std::copy_n(kept + stride_, sectors_, clay.inner_mut(slot.row).data());
  if (slot.thickness != clay.row_thickness(slot.row)) {
    clay.set_row_thickness(slot.row, slot.thickness);
    lowest_ = std::min(lowest_, slot.row);
  }
  settle(clay, slot.row);
  clay.mark_dirty(slot.row);
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
    lowest_ = clay.rows();
    going_back_ = true;
    return false;
  }
  for (; rows > 0 && next_ > steps_.back().first; --rows) put_back(clay, --next_);
  if (next_ > steps_.back().first) return false;
  // Restacking would carry the floor along: it is put where it was afterwards.
  if (lowest_ < clay.rows()) clay.restack(lowest_);
  clay.set_floor(steps_.back().floor_rows, steps_.back().floor_top);
  while (clay.take_change(0) >= 0) {
  }
  in_step_.clear();
  going_back_ = false;
  lasted_ = 0.0;
  return true;
}

void History::add_to(StateHash& hash) const {
  hash.add(next_);
  hash.add(static_cast<std::uint64_t>(steps_.size()));
  hash.add(steps_.back().first);
  hash.add(static_cast<std::uint64_t>(going_back_));
}

}  // namespace onggi::clay
