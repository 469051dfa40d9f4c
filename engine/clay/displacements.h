#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/clay/block_run.h"

namespace onggi {

/// How far one face moved within this tick, for each element, and where to look: contact writes it,
/// and effects near the contact read it. A Clay has it only if an effect asked for it:
/// Clay::keep_displacements(). Allocates only when made. Not safe across threads.
class Displacements {
 public:
  static constexpr int kBlock = 8;

  /// With `rounded`, it also keeps what rounding left over of what an effect did to the face.
  Displacements(int rows, int stride, bool rounded = false)
      : by_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride)),
        rounded_(rounded ? by_.size() : 0),
        blocks_(static_cast<std::size_t>(stride / kBlock)),
        stride_(static_cast<std::size_t>(stride)) {
    forget_where(rows);
  }

  /// By stored row (row_order.h). Metres, >= 0: inwards outside, outwards inside. stride() floats.
  float* row(int stored) { return by_.data() + static_cast<std::size_t>(stored) * stride_; }
  /// Of stored row 0, and the others a stride() apart: what is owed to each radius, less than a
  /// float's last digit, m. Null where it is not kept. A row that comes to stand elsewhere keeps
  /// its own: nobody would see a digit of another.
  float* rounded() { return rounded_.empty() ? nullptr : rounded_.data(); }
  /// Something of the row at place `j` may have been moved, within these blocks.
  void mark(int j, BlockRun run) {
    first_ = std::min(first_, j);
    end_ = std::max(end_, j + 1);
    std::fill(blocks_.begin() + run.begin, blocks_.begin() + run.end, std::uint8_t{1});
  }

  bool any() const { return first_ < end_; }
  int first_row() const { return first_; }
  int end_row() const { return end_; }
  /// The next run of marked blocks from block `from` on; begin == end if there is none.
  BlockRun run_from(int from) const {
    const auto begin = std::find(blocks_.begin() + from, blocks_.end(), 1);
    const auto end = std::find(begin, blocks_.end(), 0);
    return {static_cast<int>(begin - blocks_.begin()), static_cast<int>(end - blocks_.begin())};
  }

  /// Clears all moves; `stored`: the row at each place. O(marked elements).
  void clear(std::span<const int> stored) {
    for (BlockRun run = run_from(0); run.any(); run = run_from(run.end))
      for (int j = first_; j < end_; ++j) {
        float* const moved = row(stored[static_cast<std::size_t>(j)]);
        std::fill(moved + run.begin * kBlock, moved + run.end * kBlock, 0.0f);
      }
    forget_where(static_cast<int>(stored.size()));
  }
  /// Row `stored` is inserted at place `j`, over `like`, and counts as moved like it.
  void open(int j, int stored, int like) {
    if (j > first_ && j <= end_) std::copy_n(row(like), stride_, row(stored));
    if (j <= first_) ++first_;
    if (j <= end_) ++end_;
  }
  /// The row at place `j` is removed; it was not moved.
  void close(int j) {
    if (j < first_) --first_;
    if (j < end_) --end_;
  }

 private:
  void forget_where(int rows) {
    first_ = rows;
    end_ = 0;
    std::ranges::fill(blocks_, std::uint8_t{0});
  }

  std::vector<float> by_;
  std::vector<float> rounded_;
  std::vector<std::uint8_t> blocks_;  // 1 where marked
  std::size_t stride_;
  int first_ = 0, end_ = 0;
};

}  // namespace onggi
