#include "kiosk/loop/row_channel.h"

#include <algorithm>
#include <cstring>

namespace onggi::loop {

namespace {
constexpr int kMostBuffers = 512;
}

RowChannel::RowChannel(int rows, int sectors)
    : sectors_(sectors),
      rows_(static_cast<std::size_t>(std::min(rows, kMostBuffers))),
      free_(rows_.size() + 1),
      full_(rows_.size() + 1) {
  for (Row& row : rows_) {
    row.radii.resize(2 * static_cast<std::size_t>(sectors));
    free_.try_enqueue(&row);
  }
}

void RowChannel::publish(Scene& scene, int most) noexcept {
  if (!asked_.load(std::memory_order_acquire)) return;
  for (int n = 0; n < most; ++n) {
    Row* buffer = nullptr;
    if (!free_.try_dequeue(buffer)) return;  // The main thread is behind; the rows stay marked.
    // Go on where the last tick stopped, or a row that changes all the time would starve those
    // above.
    int j = scene.take_dirty_row(next_);
    if (j < 0 && next_ > 0) j = scene.take_dirty_row(0);
    if (j < 0) {
      // Only the main thread may put into free_, so an unused buffer goes the long way round.
      buffer->row = -1;
      full_.try_enqueue(buffer);
      asked_.store(false, std::memory_order_relaxed);
      next_ = 0;
      return;
    }
    buffer->row = j;
    buffer->middle = scene.clay().row_height(j);
    buffer->rim = scene.clay().rim_height();
    buffer->floor = scene.clay().floor_top();
    buffer->torn = scene.torn(j);
    const std::size_t bytes = static_cast<std::size_t>(sectors_) * sizeof(float);
    std::memcpy(buffer->radii.data(), scene.clay().outer(j).data(), bytes);
    std::memcpy(buffer->radii.data() + sectors_, scene.clay().inner(j).data(), bytes);
    full_.try_enqueue(buffer);
    next_ = j + 1 < scene.clay().rows() ? j + 1 : 0;
  }
}

RowChannel::Row* RowChannel::take() noexcept {
  Row* row = nullptr;
  while (full_.try_dequeue(row)) {
    if (row->row >= 0) return row;
    free_.try_enqueue(row);
  }
  return nullptr;
}

void RowChannel::give_back(Row* row) noexcept { free_.try_enqueue(row); }

}  // namespace onggi::loop
