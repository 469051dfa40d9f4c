#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/clay/block_run.h"

namespace onggi {

/// How far one face was moved within this tick, element by element, and where to look: contact
/// writes it, effects that work about the contact read it. A Clay has them only where an effect
/// asked for them: Clay::keep_displacements(). Allocates only when made. Not safe across threads.
class Displacements {
 public:
  static constexpr int kBlock = 8;

  Displacements(int rows, int stride)
      : by_(static_cast<std::size_t>(rows) * static_cast<std::size_t>(stride)),
        blocks_(static_cast<std::size_t>(stride / kBlock)),
        stride_(static_cast<std::size_t>(stride)) {
    forget_where(rows);
  }

  /// Metres, >= 0: inwards outside, outwards inside. stride() floats.
  float* row(int j) { return by_.data() + static_cast<std::size_t>(j) * stride_; }
  /// Something of row `j` may have been moved, within these blocks.
  void mark(int j, BlockRun run) {
    first_ = std::min(first_, j);
    end_ = std::max(end_, j + 1);
    std::fill(blocks_.begin() + run.begin, blocks_.begin() + run.end, std::uint8_t{1});
  }

  bool any() const { return first_ < end_; }
  int first_row() const { return first_; }
  int end_row() const { return end_; }
  /// The next marked blocks that lie together, from block `from` on; none: begin == end.
  BlockRun run_from(int from) const {
    const auto begin = std::find(blocks_.begin() + from, blocks_.end(), 1);
    const auto end = std::find(begin, blocks_.end(), 0);
    return {static_cast<int>(begin - blocks_.begin()), static_cast<int>(end - blocks_.begin())};
  }

  /// Back to nothing moved. O(what was marked).
  void clear(int rows) {
    for (BlockRun run = run_from(0); run.any(); run = run_from(run.end))
      for (int j = first_; j < end_; ++j)
        std::fill(row(j) + run.begin * kBlock, row(j) + run.end * kBlock, 0.0f);
    forget_where(rows);
  }

 private:
  void forget_where(int rows) {
    first_ = rows;
    end_ = 0;
    std::ranges::fill(blocks_, std::uint8_t{0});
  }

  std::vector<float> by_;
  std::vector<std::uint8_t> blocks_;  // 1 where marked
  std::size_t stride_;
  int first_ = 0, end_ = 0;
};

}  // namespace onggi
