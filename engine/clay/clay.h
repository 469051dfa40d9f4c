#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/clay/clay_def.h"
#include "engine/clay/displacements.h"
#include "engine/clay/row_areas.h"
#include "engine/clay/row_order.h"
#include "engine/clay/row_set.h"
#include "engine/math/vectors.h"
#include "engine/profile/profile.h"

namespace onggi {

/// The circular sector elements (Lee, Han & Choi 2008, section 2), with an outer and an inner
/// radius each. Element (row j, sector i) spans row_thickness(j) round height row_height(j) and the
/// angle [i, i+1) * 2 pi / sectors; its ray is at the middle, (i + 0.5) * 2 pi / sectors. Angles
/// are in the clay's own turning frame, x towards angle 0, z towards angle pi/2. Invariant: 0 <=
/// inner, inner + wall_min <= outer <= radius_max to a float's rounding; inner == 0 on floor rows;
/// rows are stacked without gaps, each of some thickness, and those below floor_top() are solid.
/// Rows are indexed by their place in the stack, 0 at the foot. Where rows divide and join
/// (row_division.h) their number changes; stored() gives the stored row at a place.
/// Not safe across threads; allocation only in create().
class Clay {
 public:
  /// `vectors`: instruction set for loops over elements, one of vectors_here(); no part of its
  /// state.
  /// `spare_rows`, >= 0: rows that may be inserted beyond the lump's.
  static Result<Clay> create(const ClayDef& def, Vectors vectors = best_vectors(),
                             int spare_rows = 0);

  const ClayDef& def() const { return def_; }
  Vectors vectors() const { return vectors_; }
  int rows() const { return order_.rows(); }
  int room() const { return order_.room(); }  ///< Largest number of rows.
  /// The stored row at place `j`, and the place of a stored row (RowOrder::kSpare: none).
  int stored(int j) const { return order_.at(j); }
  std::span<const int> stored() const { return order_.stored(); }
  int place_of(int stored) const { return order_.place_of(stored); }
  /// Number of rows that can still be inserted.
  int spare_rows() const { return order_.spare(); }
  int next_spare() const { return order_.next(); }  ///< The stored row that insert_row() takes.
  /// Thickness of a fresh lump's rows, m.
  double first_thickness() const { return def_.height / def_.rows; }
  int sectors() const { return def_.sectors; }
  /// Floats from one row to the next: sectors, rounded up to a multiple of 8.
  int stride() const { return stride_; }
  int floor_rows() const { return floor_rows_; }
  double row_height(int j) const { return row_height_[static_cast<std::size_t>(j)]; }
  std::span<const double> row_heights() const { return {row_height_.data(), count()}; }
  double row_thickness(int j) const { return row_thickness_[static_cast<std::size_t>(j)]; }
  std::span<const double> row_thicknesses() const { return {row_thickness_.data(), count()}; }
  /// Upper face of the solid floor, metres: above the middle of row floor_rows() - 1, and not above
  /// the middle of row floor_rows().
  double floor_top() const { return floor_top_; }
  /// Height of the rim: the upper edge of the top row, metres.
  double rim_height() const { return row_height(rows() - 1) + 0.5 * row_thickness(rows() - 1); }
  /// Lowest row whose middle lies above `height`; rows() when none does. O(log rows).
  int first_row_above(double height) const;

  std::span<const float> outer(int j) const { return {outer_.data() + start(j), width()}; }
  std::span<const float> inner(int j) const { return {inner_.data() + start(j), width()}; }
  /// The caller keeps the invariant and calls mark_dirty(j). Beyond the row, up to stride(), lies
  /// padding that no tool touches: -1e9 outside, 1e9 inside, with a ray of (0, 0).
  std::span<float> outer_mut(int j) { return forget_row(j), pressable_outer(j); }
  std::span<float> inner_mut(int j) { return forget_row(j), pressable_inner(j); }
  std::span<const float> ray_cos() const { return ray_cos_; }  ///< stride() values, one a sector.
  std::span<const float> ray_sin() const { return ray_sin_; }

  /// Metres, > 0. The caller then calls restack() once, with the lowest row that it changed.
  void set_row_thickness(int j, double thickness) {
    row_thickness_[static_cast<std::size_t>(j)] = thickness;
    changed_.add(stored(j));
    if (areas_) areas_->mark(j);
  }
  /// Stacks row `from` and those above anew on the row below, and marks them moved. A lump that is
  /// solid to the top stays so. Otherwise the floor's top keeps its relative place between two
  /// middles. O(rows() - from).
  void restack(int from) { stack(from, true); }
  /// The same for rows that divided or joined: the floor's top stays where it is.
  void restack_divided(int from) { stack(from, false); }
  /// Opens the topmost solid row with a hole of `radius` (clipped to what the wall needs).
  /// O(sectors). The caller then sets the floor by lower_floor().
  void open_floor_row(double radius);
  /// Sets the floor's top, m, not above floor_top(). Marks the row over it dirty.
  void lower_floor(double top);
  /// Inserts a spare row at place `j` (1..rows()) and moves those from there on up by one. The row
  /// has no thickness, lies at the upper edge of the one below it, and counts as moved like that
  /// one in this tick. Its radii are those it left with, and its area is unknown. The caller keeps
  /// the invariant, and restacks. `solid`: it belongs to the floor. Marks it and those above dirty.
  /// O(rows above).
  void insert_row(int j, bool solid);
  /// Removes the row at place `j`; those above come down by one. It was not moved in this tick, and
  /// is not the last. The caller restacks. Marks those above dirty. O(rows above).
  void erase_row(int j);
  /// Restores an earlier pair: number of solid rows, and the floor's upper face in metres, clamped
  /// to where those rows are now.
  void set_floor(int solid, double top);

  /// Bounds of row `j`: no outer radius is larger, and no inner one smaller. Contact skips what
  /// lies beyond. The bound may be wider than the true extremes: a press reduces the largest
  /// radius, and finding the new one would mean looking at all 360 elements for a dozen pressed
  /// ones. Too wide costs time; too narrow would let a tool pass through clay, so writers widen it
  /// first.
  float outer_most(int j) const { return outer_most_[static_cast<std::size_t>(j)]; }
  float inner_least(int j) const { return inner_least_[static_cast<std::size_t>(j)]; }
  std::span<const float> outer_most() const { return {outer_most_.data(), count()}; }
  std::span<const float> inner_least() const { return {inner_least_.data(), count()}; }
  /// As outer_mut() and inner_mut(), for callers that report what they enlarge by widen_extent().
  std::span<float> pressable_outer(int j) { return {outer_.data() + start(j), width()}; }
  std::span<float> pressable_inner(int j) { return {inner_.data() + start(j), width()}; }
  /// By stored row: stride() floats each, one after the other.
  const float* stored_outer(int stored) const { return outer_.data() + begin_of(stored); }
  const float* stored_inner(int stored) const { return inner_.data() + begin_of(stored); }
  float* stored_outer(int stored) { return outer_.data() + begin_of(stored); }
  float* stored_inner(int stored) { return inner_.data() + begin_of(stored); }
  void widen_extent(int j, float outer_most, float inner_least);
  /// Marks the row's radii as unknown.
  void forget_row(int j) {
    widen_extent(j, 1e9f, 0.0f);
    if (areas_) areas_->forget(j);
  }
  /// Sets the row's extent after looking at all of it.
  void set_extent(int j, float outer_most, float inner_least);
  /// The next of `rows` rows in turn: 0, 1, 2 ... from call to call.
  int next_measured(int rows) {
    return static_cast<int>(measured_++ % static_cast<unsigned>(rows));
  }

  /// Starts keeping the area of every row (row_areas.h). Allocates, and measures every row: not for
  /// the tick. areas() is null if nobody asked.
  void keep_areas();
  RowAreas* areas() { return areas_ ? &*areas_ : nullptr; }
  const RowAreas* areas() const { return areas_ ? &*areas_ : nullptr; }
  /// From now on it is kept how far contact moves each element in a tick (displacements.h); whoever
  /// runs the tick clears them. With `rounded`, what rounding leaves over of an effect's work is
  /// kept too (Displacements::rounded). Allocates. Null where nobody asked.
  void keep_displacements(bool rounded = true);
  Displacements* displacements(bool inside) {
    return displacements_.empty() ? nullptr : &displacements_[inside ? 1 : 0];
  }
  /// Area of row `j`'s cross-section, m^2. O(sectors).
  double measured_area(int j) const;

  /// Row `j` may have been moved in this tick.
  bool was_moved(int j) const {
    return std::ranges::any_of(displacements_, [j](const Displacements& each) {
      return j >= each.first_row() && j < each.end_row();
    });
  }
  /// Clears the moves of this tick, on both faces.
  void forget_displacements();

  /// Rows changed since they were last taken, for code that draws them.
  void mark_dirty(int j) { dirty_.add(j), changed_.add(stored(j)); }
  /// Row `first` + k for each bit k of `which`.
  void mark_dirty(int first, std::uint64_t which);
  /// Marks a row to be drawn again with unchanged radii.
  void mark_to_draw(int j) { moved_.add(j); }
  /// Marks all rows to be drawn; none has changed.
  void mark_all_dirty();
  /// Takes and clears the lowest dirty row at or above `from`; -1 when none is left.
  int take_dirty(int from = 0) { return dirty_.take(std::max(from, 0)); }
  /// The same for rows that only moved, tore or healed. Take the dirty ones first: a row may be
  /// both.
  int take_moved(int from = 0) { return moved_.take(std::max(from, 0)); }
  /// The dirty rows by storage index, for code that keeps old rows (history.h).
  int take_change(int from = 0) { return changed_.take(from); }
  void forget_change(int stored) { changed_.remove(stored); }

  /// Resets to the lump, spread over calls: each call does at most `element_budget` elements (at
  /// least one row) and returns true once all is done.
  bool renew_some(int element_budget);

  /// Mean outer and inner radius of every row, as a Profile. O(rows x sectors); allocates; not for
  /// the tick.
  Profile profile() const;
  /// Clay volume, m^3. O(rows x sectors).
  double volume() const;
  /// Hash of every radius and row height, of the order of moved rows, and of the progress of a
  /// renew. O(rows x sectors).
  std::uint64_t hash() const;

 private:
  Clay() = default;
  std::size_t count() const { return static_cast<std::size_t>(rows()); }
  std::size_t width() const { return static_cast<std::size_t>(def_.sectors); }
  std::size_t padded() const { return static_cast<std::size_t>(stride_); }
  std::size_t begin_of(int stored) const { return static_cast<std::size_t>(stored) * padded(); }
  std::size_t start(int j) const { return begin_of(stored(j)); }
  void lay_lump(int j);
  void lay_rows();
  void stack(int from, bool floor_moves);

  ClayDef def_;
  Vectors vectors_ = Vectors::plain;
  int stride_ = 0;
  int floor_rows_ = 0;
  double floor_top_ = 0.0;
  RowOrder order_;
  std::vector<double> row_height_, row_thickness_;
  std::vector<float> outer_, inner_;  // by stored row
  std::vector<float> ray_cos_, ray_sin_;
  std::vector<float> outer_most_, inner_least_;  // a row's extent; no part of the clay's state
  unsigned measured_ = 0;
  RowSet dirty_, moved_;
  RowSet changed_;  // by stored row
  std::optional<RowAreas> areas_;
  std::vector<Displacements> displacements_;  // of the outside and the inside, or none
  int sweep_row_ = 0;
};

}  // namespace onggi
