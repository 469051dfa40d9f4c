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

/// Walls that were pulled too thin or opened too far are torn, ring by ring: contact passes through
/// a torn ring (RowAreas::torn), and nothing that is done to it mends it. Only a fresh lump does,
/// or going back to before it tore. Allocates only when made. Not safe across threads.
class Tearing {
 public:
  /// `def` says that walls can tear: see tears().
  explicit Tearing(Clay& clay);

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Tearing make(const Effects&, Clay& clay) { return Tearing(clay); }
  void run(const StageWork& work) noexcept;

  /// Stage 6.6: rings that changed since they were last looked at take turns; one whose wall is
  /// somewhere thinner than `def.tear_thickness`, or is wider than the lump's by more than
  /// `def.tear_strain`, tears. All that wait are looked at within 0.1 s. `step`: History::depth()
  /// of what tears them. `last`: nobody after it asks which rows changed. O(sectors) a row.
  void look(const WallsDef& def, Clay& clay, double seconds, std::uint64_t step,
            bool last) noexcept;
  /// A fresh lump was laid in `step`.
  void lay(Clay& clay, std::uint64_t step) noexcept;
  /// `step` was taken back, and all after it: what tore in them is whole.
  void go_back(Clay& clay, std::uint64_t step) noexcept;

  void forget(Clay& clay, const Laid& laid) noexcept {
    laid.fresh ? lay(clay, laid.step) : go_back(clay, laid.step);
  }

  /// Rows that are divided or joined are whole.
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined& joined) noexcept;

  bool any() const { return torn_rows_ > 0; }
  /// Some row is torn, and the last of them tore before `step`.
  bool torn_before(std::uint64_t step) const { return any() && events_.back().step < step; }
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  static constexpr int kFreshLump = std::numeric_limits<int>::min();
  struct Event {
    std::uint64_t step = 0;
    int row = kFreshLump;  // stored, that tore
  };
  bool tears_now(const WallsDef& def, const Clay& clay, int j) const noexcept;
  void note(Event event) noexcept;
  int next_unseen() noexcept;

  RowSet unseen_;                        // rows to be looked at
  std::vector<Event> events_;            // the steps never fall; never grows
  double hollow_square_, solid_square_;  // of what the lump's rings were like: see tears_now()
  int solid_rows_;                       // of the lump
  std::size_t lump_;                     // events that one has at the most
  int torn_rows_ = 0;
  int next_ = 0;
  double owed_ = 0.0;  // rows, of which a part's turn has come
};

}  // namespace onggi::effects
