#include "engine/clay/clay.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/clay/ray.h"
#include "engine/clay/row_area.h"
#include "engine/clay/row_means.h"
#include "engine/math/hash.h"
#include "engine/math/portable.h"

namespace onggi {

Result<Clay> Clay::create(const ClayDef& def, Vectors vectors, int spare_rows) {
  if (auto good = validate(def, "clay"); !good) return tl::unexpected<Problem>(good.error());
  Clay clay;
  clay.def_ = def;
  clay.vectors_ = vectors;
  clay.stride_ = (def.sectors + 7) / 8 * 8;
  clay.order_ = RowOrder(def.rows, spare_rows);
  const auto rows = static_cast<std::size_t>(clay.room());

  clay.row_height_.resize(rows);
  clay.row_thickness_.resize(rows);
  clay.lay_rows();
  clay.ray_cos_.assign(clay.padded(), 0.0f);
  clay.ray_sin_.assign(clay.padded(), 0.0f);
  for (int i = 0; i < def.sectors; ++i) {
    const clay::Ray ray = clay::ray_of(i, def.sectors);
    clay.ray_cos_[static_cast<std::size_t>(i)] = ray.cos;
    clay.ray_sin_[static_cast<std::size_t>(i)] = ray.sin;
  }
  clay.outer_.assign(rows * clay.padded(), -1e9f);
  clay.inner_.assign(rows * clay.padded(), 1e9f);
  clay.outer_most_.resize(rows);
  clay.inner_least_.resize(rows);
  clay.dirty_ = clay.moved_ = clay.changed_ = RowSet(clay.room());
  for (int j = 0; j < def.rows; ++j) clay.lay_lump(j);
  return clay;
}

int Clay::first_row_above(double height) const {
  const std::span<const double> heights = row_heights();
  const auto at = std::upper_bound(heights.begin(), heights.end(), height);
  return static_cast<int>(at - heights.begin());
}

void Clay::lay_rows() {
  floor_rows_ = 0;
  floor_top_ = def_.floor_thickness;
  for (int j = 0; j < def_.rows; ++j) {
    const auto n = static_cast<std::size_t>(j);
    row_thickness_[n] = def_.height / def_.rows;
    row_height_[n] = (j + 0.5) * def_.height / def_.rows;
    if (row_height_[n] < def_.floor_thickness) floor_rows_ = j + 1;
  }
}

void Clay::stack(int from, bool floor_moves) {
  const bool solid = floor_rows_ == rows();
  // The floor's top lies between two middles; one or both of them will move.
  const bool carries = floor_moves && !solid && from <= floor_rows_;
  const auto middle_below = [&] { return floor_rows_ > 0 ? row_height(floor_rows_ - 1) : 0.0; };
  double share = 0.0;
  if (carries) share = (floor_top_ - middle_below()) / (row_height(floor_rows_) - middle_below());
  double edge = from > 0 ? row_height(from - 1) + 0.5 * row_thickness(from - 1) : 0.0;
  for (int j = from; j < rows(); ++j) {
    const double thickness = row_thickness(j);
    row_height_[static_cast<std::size_t>(j)] = edge + 0.5 * thickness;
    edge += thickness;
    moved_.add(j);
  }
  if (solid) floor_top_ = rim_height();
  if (carries)
    floor_top_ = std::min(middle_below() + share * (row_height(floor_rows_) - middle_below()),
                          row_height(floor_rows_));
}

void Clay::keep_areas() {
  if (areas_) return;
  areas_.emplace(room(), stride_);
  for (int j = 0; j < rows(); ++j) areas_->set(j, measured_area(j));
}

void Clay::keep_displacements(bool rounded) {
  if (!displacements_.empty()) return;
  displacements_.reserve(2);
  for (int n = 0; n < 2; ++n) displacements_.emplace_back(room(), stride_, rounded);
}

void Clay::forget_displacements() {
  for (Displacements& each : displacements_) each.clear(stored());
}

void Clay::insert_row(int j, bool solid) {
  const double edge = row_height(j - 1) + 0.5 * row_thickness(j - 1);
  const int like = stored(j - 1);
  const int row = order_.insert(j);
  clay::open_place(row_height_, j, edge);
  clay::open_place(row_thickness_, j);
  clay::open_place(outer_most_, j, 1e9f);
  clay::open_place(inner_least_, j, 0.0f);
  if (solid) ++floor_rows_;
  if (areas_) {
    areas_->open(j);
    areas_->forget(j);
  }
  for (Displacements& each : displacements_) each.open(j, row, like);
  changed_.add(row);
  dirty_.add_range(j, rows());
}

void Clay::erase_row(int j) {
  order_.erase(j);
  clay::close_place(row_height_, j);
  clay::close_place(row_thickness_, j);
  clay::close_place(outer_most_, j);
  clay::close_place(inner_least_, j);
  if (j < floor_rows_) --floor_rows_;
  if (areas_) areas_->close(j);
  for (Displacements& each : displacements_) each.close(j);
  dirty_.remove(rows());
  moved_.remove(rows());
  dirty_.add_range(std::max(std::min(j, rows() - 1), 0), rows());
}

void Clay::mark_dirty(int first, std::uint64_t which) {
  dirty_.add(first, which);
  if (order_.plain()) return changed_.add(first, which);
  for (; which != 0; which &= which - 1) changed_.add(stored(first + std::countr_zero(which)));
}

double Clay::measured_area(int j) const {
  const double all = clay::area_kernel(vectors_).squares(static_cast<int>(width()), outer(j).data(),
                                                         inner(j).data());
  return portable::kPi / def_.sectors * all;
}

void Clay::open_floor_row(double radius) {
  const int j = --floor_rows_;
  const auto wall_min = static_cast<float>(def_.wall_min);
  const auto hole = static_cast<float>(std::max(radius, def_.radius_min));
  const std::span<const float> out = outer(j);
  const std::span<float> in = inner_mut(j);
  for (std::size_t i = 0; i < out.size(); ++i) in[i] = std::min(hole, out[i] - wall_min);
  mark_dirty(j);
}

void Clay::lower_floor(double top) {
  floor_top_ = top;
  mark_dirty(std::min(floor_rows_, rows() - 1));
}

void Clay::set_floor(int solid, double top) {
  floor_rows_ = solid;
  // The floor's top of a solid lump is the rim. It never leaves its rows.
  const double low = solid > 0 ? row_height(solid - 1) : 0.0;
  floor_top_ = solid == rows() ? rim_height() : std::clamp(top, low, row_height(solid));
}

void Clay::lay_lump(int j) {
  const bool solid = j < floor_rows_;
  std::ranges::fill(outer_mut(j), static_cast<float>(def_.outer_radius));
  std::ranges::fill(inner_mut(j), solid ? 0.0f : static_cast<float>(def_.inner_radius));
  set_extent(j, outer(j).front(), inner(j).front());
  mark_dirty(j);
}

void Clay::widen_extent(int j, float outer_most, float inner_least) {
  const auto n = static_cast<std::size_t>(j);
  outer_most_[n] = std::max(outer_most_[n], outer_most);
  inner_least_[n] = std::min(inner_least_[n], inner_least);
}

void Clay::set_extent(int j, float outer_most, float inner_least) {
  const auto n = static_cast<std::size_t>(j);
  outer_most_[n] = outer_most;
  inner_least_[n] = inner_least;
}

void Clay::mark_all_dirty() { dirty_.add_range(0, rows()); }

bool Clay::renew_some(int element_budget) {
  if (sweep_row_ == 0) lay_rows();
  const int end = std::min(def_.rows, sweep_row_ + std::max(1, element_budget / stride_));
  for (; sweep_row_ < end; ++sweep_row_) lay_lump(sweep_row_);
  if (sweep_row_ < def_.rows) return false;
  sweep_row_ = 0;
  return true;
}

Profile Clay::profile() const {
  std::vector<double> outer_means, inner_means;
  double spread = 0.0;
  outer_means.reserve(count());
  inner_means.reserve(count());
  for (int j = 0; j < rows(); ++j) {
    outer_means.push_back(clay::row_mean(outer(j)));
    inner_means.push_back(clay::row_mean(inner(j)));
    spread += clay::row_spread(outer(j), outer_means.back());
  }
  Profile out = clay::outline_of(row_heights(), outer_means, inner_means, rim_height());
  out.out_of_round = std::sqrt(spread / (1.0 * rows() * sectors()));
  return out;
}

double Clay::volume() const {
  const double half_sector = portable::kPi / def_.sectors;
  double sum = 0.0;
  for (int j = 0; j < rows(); ++j) {
    const std::span<const float> out = outer(j);
    const std::span<const float> in = inner(j);
    double squares = 0.0;
    for (std::size_t i = 0; i < out.size(); ++i)
      squares += (double{out[i]} - double{in[i]}) * (double{out[i]} + double{in[i]});
    sum += squares * half_sector * row_thickness(j);
  }
  return sum;
}

std::uint64_t Clay::hash() const {
  StateHash hash;
  for (int j = 0; j < rows(); ++j) {
    hash.add(row_height(j));
    hash.add(row_thickness(j));
    hash.add(outer(j));
    hash.add(inner(j));
  }
  hash.add(floor_top_);
  hash.add(static_cast<std::uint64_t>(floor_rows_));
  hash.add(static_cast<std::uint64_t>(sweep_row_));
  if (!order_.plain() || rows() != def_.rows)
    for (const int row : stored()) hash.add(static_cast<std::uint64_t>(row));
  return hash.value();
}

}  // namespace onggi
