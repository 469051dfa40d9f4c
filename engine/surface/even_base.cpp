#include "engine/surface/even_base.h"

#include <algorithm>
#include <cstdlib>

namespace onggi::surface {

EvenBase::EvenBase(const Surface& surface, int first, int count)
    : surface_(&surface), first_(first), count_(count) {
  const auto cells = static_cast<std::size_t>(count);
  for (Read& row : read_) row.base.resize(cells + 2 * kReach), row.apart.resize(cells);
  out_.resize(cells), sum_.resize(cells), cells_.resize(cells);
}

const EvenBase::Read& EvenBase::read(int j) {
  Read& row = read_[static_cast<std::size_t>(j % kKept)];
  if (row.row == j) return row;
  row.row = j;
  row.slip = false;
  for (int n = 0; n < count_ + 2 * kReach; ++n) {
    const int i = wrapped(std::int64_t{first_} + n - kReach);
    const int slip = surface_->slip(j, i).thickness();
    row.base[static_cast<std::size_t>(n)] = surface_->relief(j, i) * int{kNanometres} + slip;
    if (n < kReach || n >= count_ + kReach) continue;
    row.apart[static_cast<std::size_t>(n - kReach)] = slip / 2;
    row.slip = row.slip || slip > 0;
  }
  return row;
}

std::span<const int> EvenBase::row(int j) {
  const int last = surface_->rows() - 1;
  j = std::clamp(j, 0, last);
  const Read& own = read(j);
  const int* middle = own.base.data() + kReach;
  if (!own.slip) return {middle, static_cast<std::size_t>(count_)};
  std::fill(sum_.begin(), sum_.end(), 0);
  std::fill(cells_.begin(), cells_.end(), 0);
  for (int k = std::max(j - kReach, 0); k <= std::min(j + kReach, last); ++k) {
    const int* beside = read(k).base.data();
    for (int off = 0; off <= 2 * kReach; ++off)
      for (int n = 0; n < count_; ++n) {
        const int higher = beside[n + off] - middle[n];
        const int alike = std::abs(higher) <= own.apart[static_cast<std::size_t>(n)] ? 1 : 0;
        sum_[static_cast<std::size_t>(n)] += alike * higher;
        cells_[static_cast<std::size_t>(n)] += alike;
      }
  }
  for (int n = 0; n < count_; ++n) {
    const auto at = static_cast<std::size_t>(n);
    out_[at] = middle[n] + static_cast<int>(floor_div(sum_[at], cells_[at]));
  }
  return out_;
}

}  // namespace onggi::surface
