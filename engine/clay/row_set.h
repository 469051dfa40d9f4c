#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/math/hash.h"

namespace onggi {

/// A set of rows, a bit each, for example the rows to draw, measure or keep. Searching passes 64 at
/// a time. Allocates only when made. Not safe across threads.
class RowSet {
 public:
  /// Room for none.
  RowSet() = default;
  /// Room for rows 0 to rows - 1; empty.
  explicit RowSet(int rows) : words_((static_cast<std::size_t>(rows) + 63) / 64) {}

  /// Capacity: rows rounded up to a multiple of 64.
  int room() const { return static_cast<int>(64 * words_.size()); }
  bool has(int j) const { return (words_[word(j)] & bit(j)) != 0; }

  void add(int j) { words_[word(j)] |= bit(j); }
  /// Adds row `first` + k for each bit k of `which`; all within the room.
  void add(int first, std::uint64_t which) {
    const std::size_t at = word(first);
    const int shift = first & 63;
    words_[at] |= which << shift;
    const std::uint64_t beyond = shift == 0 ? 0 : which >> (64 - shift);
    if (beyond != 0) words_[at + 1] |= beyond;
  }
  /// Adds all of `others`, which has the same room.
  void add(const RowSet& others) {
    for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= others.words_[w];
  }
  /// Adds rows `first` to `end` - 1.
  void add_range(int first, int end) {
    for (int j = first; j < end;) {
      const int next = std::min(end, (j | 63) + 1);
      words_[word(j)] |= below(next - (j & ~63)) & ~below(j & 63);
      j = next;
    }
  }
  void remove(int j) { words_[word(j)] &= ~bit(j); }
  void clear() { std::ranges::fill(words_, 0); }

  /// Removes and returns the lowest row at or above `from` (>= 0); -1 if there is none.
  int take(int from = 0) {
    std::uint64_t keep = ~std::uint64_t{0} << (from & 63);
    for (std::size_t w = word(from); w < words_.size(); ++w, keep = ~std::uint64_t{0}) {
      const std::uint64_t seen = words_[w] & keep;
      if (seen == 0) continue;
      words_[w] &= ~(seen & (~seen + 1));
      return static_cast<int>(64 * w) + std::countr_zero(seen);
    }
    return -1;
  }

  bool empty() const {
    return std::ranges::all_of(words_, [](std::uint64_t w) { return w == 0; });
  }
  /// A row is inserted: `j` is not in the set, and members from `j` on move up by one.
  void open(int j) {
    std::uint64_t carried = 0;
    for (std::size_t w = word(j); w < words_.size(); ++w) {
      const std::uint64_t stays = w == word(j) ? words_[w] & below(j & 63) : 0;
      const std::uint64_t moves = words_[w] & ~stays;
      words_[w] = stays | moves << 1 | carried;
      carried = moves >> 63;
    }
  }
  /// Row `j` is removed: members above it move down by one.
  void close(int j) {
    for (std::size_t w = word(j); w < words_.size(); ++w) {
      const std::uint64_t stays = w == word(j) ? words_[w] & below(j & 63) : 0;
      const std::uint64_t moves = w == word(j) ? words_[w] & ~below(j & 63) & ~bit(j) : words_[w];
      const std::uint64_t next = w + 1 < words_.size() ? words_[w + 1] << 63 : 0;
      words_[w] = stays | moves >> 1 | next;
    }
  }

  void add_to(StateHash& hash) const {
    for (const std::uint64_t w : words_) hash.add(w);
  }

 private:
  static std::size_t word(int j) { return static_cast<std::size_t>(j) >> 6; }
  static std::uint64_t bit(int j) { return std::uint64_t{1} << (j & 63); }
  static std::uint64_t below(int bits) {
    return bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
  }

  std::vector<std::uint64_t> words_;
};

}  // namespace onggi
