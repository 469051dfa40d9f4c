#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/clay/row_set.h"
#include "engine/math/hash.h"

namespace onggi::clay {

/// Undo for visitors: the clay before each stroke, within a fixed amount of memory. A step is one
/// touch, from first contact until the hands have been clear for kPause; a longer touch is cut
/// after kLongest. On 400 x 360 the memory holds at least half a minute of the busiest throwing.
///
/// How: a second grid lags behind the clay. A row that changed is copied from it into a ring the
/// first time in a step, and brought up to date when the step is over, some rows a tick. So no tick
/// pays for a stroke, and a step's edge is sharp to a few ticks (half a second on 18 million
/// elements). Rows are kept as they are stored; which of them came to stand and which left, in
/// order, is kept beside. Allocates in its constructor only. Not safe across threads.
class History {
 public:
  static constexpr double kPause = 0.4;    ///< s.
  static constexpr double kLongest = 3.0;  ///< s.
  static constexpr std::size_t kBytes = 32u
                                        << 20;  ///< Of the ring; more where one whole grid is more.

  static constexpr std::size_t kMostSteps = 256;  ///< The one under way too.

  explicit History(Clay& clay);

  /// Once a tick, after the clay changed. `touching`: a hand presses it. Cost follows the rows that
  /// changed: at most 2048 elements, or two rows where those are longer.
  void follow(Clay& clay, bool touching, double seconds) noexcept;
  /// Stored rows are about to come to stand, to leave, or to be given other radii because a
  /// neighbour does: once for each of them, before. O(sectors).
  void keep_row(Clay& clay, int stored) noexcept;
  /// Clay::insert_row(j) is called, or Clay::erase_row(j), with what it was told.
  void note_inserted(int j) noexcept { note({j, true, false}); }
  void note_erased(int j, bool solid) noexcept { note({j, false, solid}); }
  /// What follows is a step of its own, and what was before is kept to the last bit: at most about
  /// `element_budget` elements a call, true once it is so. Until then nobody may change the clay.
  bool begin_step(Clay& clay, int element_budget) noexcept;

  bool can_step_back() const;
  /// Number of the step under way: one more with each that ends, one less with each taken back.
  std::uint64_t depth() const { return depth_; }
  /// How long the step under way has lasted since the clay first changed in it, s.
  double lasted() const { return lasted_; }
  /// Undoes the last step, at most about `element_budget` elements a call. True when done, or if
  /// there is nothing to undo; until then nobody else may change the clay.
  bool step_back_some(Clay& clay, int element_budget) noexcept;

  /// Of what is kept, not of its radii: those follow from what the hands did.
  void add_to(StateHash& hash) const;

 private:
  struct Step {
    std::uint64_t first = 0;        // of its rows in the ring, counted from the beginning of time,
    std::uint64_t first_place = 0;  // and of its changes of place
    double floor_top = 0.0;
  };
  struct Slot {
    int row = 0;  // as it is stored
    double thickness = 0.0;
  };
  struct PlaceChange {
    int place = 0;
    bool inserted = false;
    bool solid = false;
  };

  int rows_of(int elements) const { return elements > stride_ ? elements / stride_ : 1; }
  bool keep_up(Clay& clay, int rows) noexcept;
  void end_step(const Clay& clay) noexcept;
  void note(PlaceChange change) noexcept;
  void undo_places(Clay& clay, int most) noexcept;
  void remember(int stored) noexcept;
  void settle(const Clay& clay, int stored) noexcept;
  void put_back(Clay& clay, std::uint64_t at) noexcept;
  bool reaches(const Step& step) const {
    return next_ - step.first <= slots_.size() && next_place_ - step.first_place <= places_.size();
  }
  float* ring_row(std::uint64_t at);
  float* shadow_row(int stored);

  int stride_, sectors_;
  std::vector<float> shadow_;  // outer, then inner, row by row
  std::vector<double> shadow_thickness_;
  std::unique_ptr<float[]> ring_;  // not written before it is used, so not resident either
  std::vector<Slot> slots_;
  std::vector<PlaceChange> places_;  // a ring; none where no row ever moves
  std::uint64_t next_place_ = 0;
  std::vector<Step> steps_;  // the last is under way; never grows
  RowSet in_step_;           // rows that the present step has in the ring
  RowSet unsettled_;         // rows of the step before whose shadow is not up to date
  std::uint64_t next_ = 0;
  std::uint64_t depth_ = 0;
  double clear_ = 0.0;
  double lasted_ = 0.0;
  int lowest_ = 0;  // place put back whose thickness changed
  bool going_back_ = false;
};

}  // namespace onggi::clay
