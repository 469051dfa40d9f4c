#include "kiosk/wheel/loop/row_channel.h"

#include <algorithm>

namespace onggi::loop {

namespace {
constexpr int kMostBuffers = 512;

struct Changed {
  int row = -1;
  bool shaped = false;
};

/// The next changed row from `from` on, then from the start; rows with new radii come before rows
/// that only moved. -1: none is left.
Changed next_changed(Scene& scene, int from) noexcept {
  for (const bool shaped : {true, false}) {
    const auto take = [&](int first) {
      return shaped ? scene.take_dirty_row(first) : scene.take_moved_row(first);
    };
    int row = take(from);
    if (row < 0 && from > 0) row = take(0);
    if (row >= 0) return {row, shaped};
  }
  return {};
}
}  // namespace

RowChannel::RowChannel(int rows, int sectors)
    : sectors_(static_cast<std::size_t>(sectors)),
      rows_(static_cast<std::size_t>(std::min(rows, kMostBuffers))),
      free_(rows_.size() + 1),
      full_(rows_.size() + 1) {
  for (Row& row : rows_) {
    row.radii.resize(2 * sectors_);
    free_.try_enqueue(&row);
  }
}

void RowChannel::publish(Scene& scene, int most) noexcept {
  if (!asked_.load(std::memory_order_acquire)) return;
  const Clay& clay = scene.clay();
  for (int n = 0; n < most; ++n) {
    Row* buffer = nullptr;
    if (!free_.try_dequeue(buffer)) return;  // the main thread is behind; the rows stay marked
    // Continue where the last tick stopped; otherwise a row that changes all the time would starve
    // those above.
    const Changed changed = next_changed(scene, next_);
    buffer->row = changed.row;
    if (changed.row < 0) {
      // Only the main thread may put into free_, so an unused buffer travels through full_.
      full_.try_enqueue(buffer);
      asked_.store(false, std::memory_order_relaxed);
      next_ = 0;
      return;
    }
    buffer->place = clay::place_of(clay, changed.row);
    buffer->shaped = changed.shaped;
    if (changed.shaped) {
      std::ranges::copy(clay.outer(changed.row), buffer->radii.begin());
      std::ranges::copy(clay.inner(changed.row),
                        buffer->radii.begin() + static_cast<std::ptrdiff_t>(sectors_));
    }
    full_.try_enqueue(buffer);
    next_ = changed.row + 1 < clay.rows() ? changed.row + 1 : 0;
  }
}

int RowChannel::take_into(ClayView& view) noexcept {
  int count = 0;
  Row* row = nullptr;
  // Each buffer once: the loop fills those that come free, and with a large grid as fast as they
  // are emptied here.
  for (std::size_t n = 0; n < rows_.size() && full_.try_dequeue(row); ++n) {
    if (row->row >= 0) {
      const std::span<const float> radii = row->radii;
      view.place(row->row, row->place);
      if (row->shaped) view.shape(row->row, radii.first(sectors_), radii.last(sectors_));
      ++count;
    }
    free_.try_enqueue(row);
  }
  return count;
}

void take_rest_into(ClayView& view, Scene& scene) noexcept {
  const Clay& clay = scene.clay();
  for (Changed changed = next_changed(scene, 0); changed.row >= 0;
       changed = next_changed(scene, 0)) {
    view.place(changed.row, clay::place_of(clay, changed.row));
    if (changed.shaped) view.shape(changed.row, clay.outer(changed.row), clay.inner(changed.row));
  }
}

}  // namespace onggi::loop
