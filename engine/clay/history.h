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
/// A second grid lags behind the clay. A changed row is copied from it into a ring the first time
/// in a step, and brought up to date after the step, some rows a tick. So a step's edge is sharp to
/// a few ticks (half a second on 18 million elements). Rows are kept by stored row, beside the
/// order of insertions and removals. Allocates in its constructor only. Not safe across threads.
class History {
 public:
  static constexpr double kPause = 0.4;             ///< s.
  static constexpr double kLongest = 3.0;           ///< s.
  static constexpr std::size_t kBytes = 32u << 20;  ///< Size of the ring; one whole grid if that is
                                                    ///< more.

  static constexpr std::size_t kMostSteps = 256;  ///< Including the one under way.

  explicit History(Clay& clay);

  /// What goes on in a tick: nothing, clay that moves by itself, or a hand that presses it.
  enum class Stir : std::uint8_t { none, moving, touching };
  /// Call once a tick, after the clay changed. Costs at most 2048 elements, or two rows if those
  /// are longer.
  void follow(Clay& clay, Stir stir, double seconds) noexcept;
  /// Call once for each stored row, before it is inserted, removed, or given other radii because a
  /// neighbour is. O(sectors).
  void keep_row(Clay& clay, int stored) noexcept;
  /// Call with each Clay::insert_row(j) or Clay::erase_row(j), and its arguments.
  void note_inserted(int j) noexcept { note({j, true, false}); }
  void note_erased(int j, bool solid) noexcept { note({j, false, solid}); }
  /// Ends the step and keeps what was before to the last bit: at most about `element_budget`
  /// elements a call, true when done. Until then the clay must not change. What follows counts as
  /// somebody's doing.
  bool begin_step(Clay& clay, int element_budget) noexcept;

  /// There is a step that somebody made, or in which undone clay moved by itself, and the ring
  /// still has it.
  bool can_step_back() const;
  /// Number of the step under way; each end adds one, each undo takes one.
  std::uint64_t depth() const { return depth_; }
  /// Time since the clay first changed in the step under way, s.
  double lasted() const { return lasted_; }
  /// Undoes the last step; where undone clay only settled in it, also the step before. At most
  /// about `element_budget` elements a call. True when done, or if there is nothing to undo. Until
  /// then nobody else may change the clay.
  bool step_back_some(Clay& clay, int element_budget) noexcept;

  /// Hash of the bookkeeping; radii follow from the input.
  void add_to(StateHash& hash) const;

 private:
  struct Step {
    std::uint64_t first = 0;        // first of its rows, counted over the ring's whole life,
    std::uint64_t first_place = 0;  // and first of its insertions and removals
    double floor_top = 0.0;
    bool settles = false;  // no hand has touched the clay since an undo,
    bool moves = false;    // but it moved by itself, as wet clay sags
  };
  struct Slot {
    int row = 0;  // stored row
    double thickness = 0.0;
  };
  struct PlaceChange {
    int place = 0;
    bool inserted = false;
    bool solid = false;
  };

  int rows_of(int elements) const { return elements > stride_ ? elements / stride_ : 1; }
  bool keep_up(Clay& clay, int rows) noexcept;
  bool reaches_back_to(bool moved_by_itself) const;
  void begin_touch() noexcept;
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
  std::vector<PlaceChange> places_;  // a ring; empty if rows never move
  std::uint64_t next_place_ = 0;
  std::vector<Step> steps_;  // the last is under way; never grows
  RowSet in_step_;           // rows of this step in the ring
  RowSet unsettled_;         // rows of the step before whose shadow is old
  std::uint64_t next_ = 0;
  std::uint64_t depth_ = 0;
  double clear_ = 0.0;
  double lasted_ = 0.0;
  int lowest_ = 0;  // lowest restored place whose thickness changed
  bool going_back_ = false;
  bool settling_ = false;  // from an undo until a hand touches the clay
};

}  // namespace onggi::clay
