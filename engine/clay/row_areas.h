#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace onggi {

/// The area of every row's cross-section (m^2), kept up to date by those who press, for effects
/// that need to know what a press took away; and which rows have changed since they were last
/// taken. A Clay has one only where an effect asked for it: Clay::keep_areas(). Not safe across
/// threads.
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
  std::vector<float> spare_;
};

}  // namespace onggi
