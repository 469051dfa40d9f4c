#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/clay/row_set.h"
#include "engine/effects/row_stage.h"
#include "engine/effects/walls.h"
#include "engine/math/hash.h"

namespace onggi::effects {

/// Tears walls, ring by ring, that were pulled too thin or opened too far. Contact passes through a
/// torn ring (RowAreas::torn). Only a fresh lump, or undo to before the tear, mends it. Allocates
/// only when made. Not safe across threads.
class Tearing {
 public:
  /// True if `def` sets a limit at which walls tear.
  explicit Tearing(Clay& clay);

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Tearing make(const Effects&, Clay& clay) { return Tearing(clay); }

  /// Stage 6.6: changed rings take turns, each within 0.1 s. A ring tears if its wall is somewhere
  /// thinner than WallsDef::tear_thickness, or if it is wider than it was laid by more than
  /// WallsDef::tear_strain times its strength, which is less than 1 at a joint of coils (Building).
  /// O(sectors) a row.
  void run(const StageWork& work) noexcept;
  /// A fresh lump was laid in `step`.
  void lay(Clay& clay, std::uint64_t step) noexcept;
  /// `step` and all later steps were taken back: what tore in them is whole.
  void go_back(Clay& clay, std::uint64_t step) noexcept;

  void forget(Clay& clay, const Laid& laid) noexcept {
    laid.fresh ? lay(clay, laid.step) : go_back(clay, laid.step);
  }

  void row_added(const Clay&, const RowAdded& added) noexcept { unseen_.add(added.row); }
  /// Only whole rows are divided or joined.
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined& joined) noexcept;

  bool any() const { return torn_rows_ > 0; }
  /// True if a row is torn, and the last tear came before `step`.
  bool torn_before(std::uint64_t step) const { return any() && events_.back().step < step; }
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  static constexpr int kFreshLump = std::numeric_limits<int>::min();
  struct Event {
    std::uint64_t step = 0;
    int row = kFreshLump;  // stored row that tore
  };
  bool tears_now(const StageWork& work, int j) const noexcept;
  void note(Event event) noexcept;
  int next_unseen() noexcept;

  RowSet unseen_;                        // rows to be looked at
  std::vector<Event> events_;            // steps never fall; capacity never grows
  double hollow_square_, solid_square_;  // girth of the lump's rings, squared: see tears_now()
  int solid_rows_;                       // of the lump
  std::size_t lump_;                     // events that one lump has at most
  int torn_rows_ = 0;
  int next_ = 0;
  double owed_ = 0.0;  // fraction of a row whose turn is due
};

}  // namespace onggi::effects
