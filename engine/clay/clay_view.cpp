#include "engine/clay/clay_view.h"

#include <algorithm>
#include <cmath>

#include "engine/clay/row_means.h"
#include "engine/math/portable.h"

namespace onggi {

clay::RowPlace clay::place_of(const Clay& clay, int row) noexcept {
  const RowAreas* areas = clay.areas();
  const bool torn = areas != nullptr && areas->torn(row);
  return {clay.row_height(row), clay.rim_height(), clay.floor_top(), clay.floor_rows(), torn,
          clay.rows()};
}

void ClayView::make_room(int rows, int room, int sectors) {
  rows_ = rows;
  sectors_ = sectors;
  const auto n = static_cast<std::size_t>(std::max(rows, room));
  outer_.resize(n * width());
  inner_.resize(n * width());
  for (auto* each : {&mean_outer_, &mean_inner_, &middle_}) each->resize(n);
  torn_.assign(n, 0);
  for (auto* each : {&shaped_at_, &placed_at_}) each->assign(n, ++change_);
}

void ClayView::lay(const ClayDef& def, int room) {
  make_room(def.rows, room, def.sectors);
  wet.clear();
  angle = cut_free = 0.0;
  rim_ = def.height;
  floor_top_ = def.floor_thickness;
  floor_rows_ = 0;
  std::ranges::fill(outer_, static_cast<float>(def.outer_radius));
  std::ranges::fill(inner_, static_cast<float>(def.inner_radius));
  for (int j = 0; j < rows_; ++j) {
    const auto n = static_cast<std::size_t>(j);
    middle_[n] = (j + 0.5) * def.height / def.rows;
    if (middle_[n] < def.floor_thickness) {
      floor_rows_ = j + 1;
      std::fill_n(inner_.begin() + static_cast<std::ptrdiff_t>(start(j)), width(), 0.0f);
    }
    mean_outer_[n] = clay::row_mean(outer(j));
    mean_inner_[n] = clay::row_mean(inner(j));
  }
}

void ClayView::take(const Clay& clay) {
  make_room(clay.rows(), clay.room(), clay.sectors());
  for (int j = 0; j < rows_; ++j) {
    place(j, clay::place_of(clay, j));
    shape(j, clay.outer(j), clay.inner(j));
  }
}

void ClayView::place(int row, const clay::RowPlace& at) noexcept {
  if (!has(row)) return;
  const auto n = static_cast<std::size_t>(row);
  middle_[n] = at.middle;
  torn_[n] = at.torn ? 1 : 0;
  rim_ = at.rim;
  floor_top_ = at.floor_top;
  floor_rows_ = at.floor_rows;
  if (at.rows > 0) rows_ = std::min(at.rows, room());
  placed_at_[n] = ++change_;
}

void ClayView::shape(int row, std::span<const float> outer, std::span<const float> inner) noexcept {
  if (!has(row) || outer.size() != width() || inner.size() != width()) return;
  const auto n = static_cast<std::size_t>(row);
  std::ranges::copy(outer, outer_.begin() + static_cast<std::ptrdiff_t>(start(row)));
  std::ranges::copy(inner, inner_.begin() + static_cast<std::ptrdiff_t>(start(row)));
  mean_outer_[n] = clay::row_mean(outer);
  mean_inner_[n] = clay::row_mean(inner);
  shaped_at_[n] = ++change_;
}

std::optional<double> ClayView::torn_wall() const {
  std::optional<double> thinnest;
  for (int j = 0; j < rows_; ++j) {
    if (!torn(j)) continue;
    for (std::size_t i = 0; i < width(); ++i) {
      const double wall = double{outer(j)[i]} - double{inner(j)[i]};
      if (!thinnest || wall < *thinnest) thinnest = wall;
    }
  }
  return thinnest;
}

Profile ClayView::profile() const {
  const auto some = [this](const std::vector<double>& all) {
    return std::span(all).first(count());
  };
  Profile out = clay::outline_of(some(middle_), some(mean_outer_), some(mean_inner_), rim_);
  double spread = 0.0;
  for (int j = 0; j < rows(); ++j) spread += clay::row_spread(outer(j), mean_outer(j));
  if (rows() > 0) out.out_of_round = std::sqrt(spread / (1.0 * rows() * sectors()));
  return out;
}

double ClayView::radius_at(double h, WallSide side) const {
  if (rows_ == 0) return 0.0;
  const std::vector<double>& means = side == WallSide::outside ? mean_outer_ : mean_inner_;
  const auto above = static_cast<std::size_t>(
      std::upper_bound(middle_.begin(), middle_.begin() + rows_, h) - middle_.begin());
  if (above == 0) return means.front();
  if (above == count()) return means[count() - 1];
  const std::size_t below = above - 1;
  const double gap = middle_[above] - middle_[below];
  const double share = gap > 0.0 ? std::clamp((h - middle_[below]) / gap, 0.0, 1.0) : 0.0;
  return means[below] * (1.0 - share) + means[above] * share;
}

double ClayView::capacity() const {
  const int rows = rows_;
  double sum = 0.0;  // of radius^2 times height
  for (int j = std::max(floor_rows(), 0); j < rows && !torn(j); ++j) {
    const double here = row_height(j);
    const double below =
        j == floor_rows() || j == 0 ? floor_top() : 0.5 * (row_height(j - 1) + here);
    const double above = j + 1 == rows ? rim_height() : 0.5 * (here + row_height(j + 1));
    double squares = 0.0;
    for (const float radius : inner(j)) squares += double{radius} * double{radius};
    sum += squares * std::max(0.0, above - below);
  }
  return rows == 0 ? 0.0 : portable::kPi * sum / sectors();
}

}  // namespace onggi
