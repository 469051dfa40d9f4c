#pragma once

#include "engine/clay/clay.h"
#include "engine/effects/volume.h"
#include "engine/math/hash.h"

namespace onggi::effects {

/// Adapts the grid to the clay (h-refinement and coarsening): which rows to divide as they get
/// thick, and which to join to keep spare rows. It only decides; clay/row_division.h does it. Needs
/// no other memory; one thread.
class Refinement {
 public:
  /// Rows that a scene keeps for it, in addition to the lump's.
  static int spare_rows(const ClayDef& def) { return def.rows; }
  /// As multiples of a fresh lump's row thickness. A thicker row is divided. Two joined rows come
  /// to at most kJoined, so that no row is divided and joined in turn.
  static constexpr double kDivided = 1.6;
  static constexpr double kJoined = 1.4;
  /// A join moves the outline by at most this share of the thinner row's thickness.
  static constexpr double kJoinError = 0.05;
  /// Changes per tick, and pairs examined per tick.
  static constexpr int kMostChanges = 4;

  struct Change {
    enum class Kind : std::uint8_t { none, divide, join } kind = Kind::none;
    int row = 0;  ///< The row, or the lower of the two.
  };
  /// Stage 6.12, up to kMostChanges times a tick: the next change to make. Rows take turns from the
  /// foot up. `clay` is as Volume::keep(), divide_row() or join_rows() left it. O(rows / 64), and
  /// O(sectors) if few spare rows are left.
  Change next(const Clay& clay, Volume& volume) noexcept;
  void add_to(StateHash& hash) const;

 private:
  Change joined(const Clay& clay) noexcept;

  int divide_from_ = 0;
  int join_from_ = 0;
};

}  // namespace onggi::effects
