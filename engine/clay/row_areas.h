#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace onggi {

/// The area of every row's cross-section (m^2), kept up to date by those who press, for effects
/// that need to know what a press took away; which rows have changed since they were last taken;
/// and which are torn. A Clay has one only where an effect asked for it: Clay::keep_areas(). Not
/// safe across threads.
class RowAreas {
 public:
  RowAreas(int rows, int stride)
      : area_(static_cast<std::size_t>(rows)),
        cut_(area_.size()),
        changed_((static_cast<std::size_t>(rows) + 63) / 64),
        unknown_(changed_.size()),
        spare_(static_cast<std::size_t>(stride)) {}

  /// Right to a float's digits of what was lost since it was last set(). Only where known(j).
  double of(int j) const { return area_[static_cast<std::size_t>(j)]; }
  bool known(int j) const { return (unknown_[word(j)] & bit(j)) == 0; }

  /// Row `j` is this large, measured.
  void set(int j, double area) {
    area_[static_cast<std::size_t>(j)] = area;
    unknown_[word(j)] &= ~bit(j);
  }
  /// A press took this from row `j`; negative where it gave. `cut`: it is gone from the pot.
  void lose(int j, double area, bool cut = false) {
    area_[static_cast<std::size_t>(j)] -= area;
    if (cut) cut_[static_cast<std::size_t>(j)] += area;
    changed_[word(j)] |= bit(j);
  }
  /// Row `j` gained this from other rows, or gave it where negative: its volume goes with it.
  void trade(int j, double area) {
    area_[static_cast<std::size_t>(j)] += area;
    keep_for(j, -area);
  }
  /// What row `j` has to give for nothing, m^2 of its cross-section.
  void keep_for(int j, double area) {
    cut_[static_cast<std::size_t>(j)] += area;
    changed_[word(j)] |= bit(j);
  }
  /// Takes what was cut from row `j`, m^2, since it was last taken.
  double take_cut(int j) { return std::exchange(cut_[static_cast<std::size_t>(j)], 0.0); }
  /// Row `j` became thinner or thicker.
  void mark(int j) { changed_[word(j)] |= bit(j); }
  /// Row `j` was written to: it is to be measured.
  void forget(int j) {
    changed_[word(j)] |= bit(j);
    unknown_[word(j)] |= bit(j);
  }
  /// Rows marked since they were last taken, added to `bits` (one bit a row). `taken`: and none is
  /// any more.
  void add_changed(std::span<std::uint64_t> bits, bool taken) {
    for (std::size_t w = 0; w < changed_.size(); ++w) {
      bits[w] |= changed_[w];
      if (taken) changed_[w] = 0;
    }
  }
  /// From now on rows may tear. Allocates.
  void keep_torn() { torn_.resize(changed_.size()); }
  /// Row `j` is torn: whoever presses it, passes through. O(1), and mend() O(rows / 64).
  void tear(int j) {
    torn_[word(j)] |= bit(j);
    any_torn_ = true;
  }
  void mend() {
    std::ranges::fill(torn_, 0);
    any_torn_ = false;
  }
  bool any_torn() const { return any_torn_; }
  bool torn(int j) const { return any_torn_ && (torn_[word(j)] & bit(j)) != 0; }
  /// A row that nobody reads, for those who write what nobody asked for.
  float* spare_row() { return spare_.data(); }
  /// Takes and clears the lowest changed row at or above `from`; -1 when none is left.
  int take_changed(int from) {
    if (from >= static_cast<int>(area_.size())) return -1;
    std::uint64_t keep = ~0ULL << (from & 63);
    for (std::size_t w = word(from); w < changed_.size(); ++w, keep = ~0ULL) {
      const std::uint64_t seen = changed_[w] & keep;
      if (seen == 0) continue;
      changed_[w] &= ~(seen & (~seen + 1));
      return static_cast<int>(w * 64) + std::countr_zero(seen);
    }
    return -1;
  }

 private:
  static std::size_t word(int j) { return static_cast<std::size_t>(j) >> 6; }
  static std::uint64_t bit(int j) { return 1ULL << (j & 63); }

  std::vector<double> area_, cut_;
  std::vector<std::uint64_t> changed_, unknown_;
  std::vector<std::uint64_t> torn_;  // none where no row can tear
  bool any_torn_ = false;
  std::vector<float> spare_;
};

}  // namespace onggi
