#pragma once

#include "engine/clay/clay.h"
#include "engine/effects/volume.h"
#include "engine/math/hash.h"

namespace onggi::effects {

/// The grid follows the clay: which rows are divided as they get thick, and which are joined so
/// that there are rows to spare (h-refinement and coarsening). It only says so; clay/row_division.h
/// does it. Needs no memory but itself; one thread.
class Refinement {
 public:
  /// Rows beyond the lump's that a scene keeps for it.
  static int spare_rows(const ClayDef& def) { return def.rows; }
  /// Of a fresh lump's thickness: a row above is divided, and two that are joined come to no more
  /// than kJoined, so that nothing is divided and joined in turns.
  static constexpr double kDivided = 1.6;
  static constexpr double kJoined = 1.4;
  /// A join moves the outline by at most this share of the thinner row's thickness.
  static constexpr double kJoinError = 0.05;
  /// Changes in a tick, and pairs that are looked at for it.
  static constexpr int kMostChanges = 4;

  struct Change {
    enum class Kind : std::uint8_t { none, divide, join } kind = Kind::none;
    int row = 0;  ///< The row, or the lower of two.
  };
  /// Stage 6.8, up to kMostChanges times a tick: the next thing to be done. Rows take turns from
  /// the foot up. `clay` is as Volume::keep() left it, or divide_row() and join_rows() did. O(rows
  /// / 64), and O(sectors) where spare rows are few.
  Change next(const Clay& clay, Volume& volume) noexcept;
  void add_to(StateHash& hash) const;

 private:
  Change joined(const Clay& clay) noexcept;

  int divide_from_ = 0;
  int join_from_ = 0;
};

}  // namespace onggi::effects
