#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/profile/profile.h"

namespace onggi {
namespace clay {

/// The position of a row, and the clay's figures that change when other rows grow or sink.
struct RowPlace {
  double middle = 0.0;     ///< Height of the row's middle, m.
  double rim = 0.0;        ///< Height of the clay, m,
  double floor_top = 0.0;  ///< and of the upper face of its floor.
  int floor_rows = 0;      ///< Solid rows.
  bool torn = false;       ///< The ring is broken open.
  int rows = 0;            ///< Of the clay; 0: unchanged.
};
RowPlace place_of(const Clay& clay, int row) noexcept;

}  // namespace clay

/// The clay as a copy for reading: screens, picture, score and keepsake use only this. It is
/// updated row by row; rows that only moved come without radii. Row means are kept, so that an
/// outline costs O(rows). Allocates only in lay() and take(). Not safe across threads.
class ClayView {
 public:
  /// A fresh lump of this grid: dry, whole and turning with the wheel. `room`: the largest number
  /// of rows (Clay::room()), at least the grid's own.
  void lay(const ClayDef& def, int room = 0);
  /// All of `clay`: the view after every row has arrived.
  void take(const Clay& clay);
  /// Takes a row's place and the figures that come with it, also the number of rows. Rows beyond
  /// the grid's room are ignored.
  void place(int row, const clay::RowPlace& at) noexcept;
  /// A row's radii, metres. Rows outside the grid, or with another width, are ignored.
  void shape(int row, std::span<const float> outer, std::span<const float> inner) noexcept;

  int rows() const { return rows_; }                             ///< 0 before the first lump.
  int room() const { return static_cast<int>(middle_.size()); }  ///< rows() at the most.
  int sectors() const { return sectors_; }
  std::span<const float> outer(int j) const { return {outer_.data() + start(j), width()}; }
  std::span<const float> inner(int j) const { return {inner_.data() + start(j), width()}; }
  double mean_outer(int j) const { return mean_outer_[static_cast<std::size_t>(j)]; }
  double mean_inner(int j) const { return mean_inner_[static_cast<std::size_t>(j)]; }
  double row_height(int j) const { return middle_[static_cast<std::size_t>(j)]; }
  double rim_height() const { return rim_; }       ///< Metres.
  double floor_top() const { return floor_top_; }  ///< Metres.
  int floor_rows() const { return floor_rows_; }
  bool torn(int j) const { return torn_[static_cast<std::size_t>(j)] != 0; }
  /// Thickness of the wall at the thinnest torn row, metres; absent if none is torn. O(torn rows x
  /// sectors).
  std::optional<double> torn_wall() const;

  /// 0 dry .. 1 dripping, at even heights from foot to rim; empty if wetness is the same
  /// everywhere.
  std::vector<float> wet;
  double angle = 0.0;     ///< Its own turning frame, rad; the wheel's until it is cut free.
  double cut_free = 0.0;  ///< Share of the section that a wire has cut; at 1 it stands still.

  /// The outline from the row means. Heights rise even while rows are in transit. O(rows x
  /// sectors).
  Profile profile() const;
  /// The pot's capacity when filled to the brim, m^3: from the floor's upper face to the rim, or to
  /// the lowest torn ring. Each sector counts with its own inner radius (Lee et al. 2008: circular
  /// sectors), each row to half-way to its neighbours: a mid-point sum. 0 before the first lump.
  /// O(rows x sectors), no allocation, the same bits on every machine.
  double capacity() const;
  /// Mean radius of a face at height `h` (clamped), metres.
  double radius_at(double h, WallSide side) const;

  /// Grows with every change, so that drawing code can tell what is new.
  std::uint64_t change() const { return change_; }
  std::uint64_t shaped_at(int j) const { return shaped_at_[static_cast<std::size_t>(j)]; }
  std::uint64_t placed_at(int j) const { return placed_at_[static_cast<std::size_t>(j)]; }

 private:
  std::size_t width() const { return static_cast<std::size_t>(sectors_); }
  std::size_t start(int j) const { return static_cast<std::size_t>(j) * width(); }
  std::size_t count() const { return static_cast<std::size_t>(rows_); }
  bool has(int row) const { return row >= 0 && row < room(); }
  void make_room(int rows, int room, int sectors);

  int rows_ = 0, sectors_ = 0, floor_rows_ = 0;
  double rim_ = 0.0, floor_top_ = 0.0;
  std::vector<float> outer_, inner_;
  std::vector<double> mean_outer_, mean_inner_, middle_;
  std::vector<std::uint8_t> torn_;
  std::vector<std::uint64_t> shaped_at_, placed_at_;
  std::uint64_t change_ = 0;
};

}  // namespace onggi
