#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/clay/history.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"

namespace onggi {

/// Clay is incompressible: what leaves a row's cross-section raises the row, what presses a row
/// down widens it. Pulling up the wall makes the pot taller and thinner. It has no numbers to set.
struct VolumeDef {
  static constexpr const char* kName = "volume";
  static std::span<const DefField<VolumeDef>> fields() { return {}; }
};

namespace effects {

/// How much clay every row holds, and the heights that follow from it: h = V / A. No row gets
/// thicker than kThickest times a fresh lump's, and no pot taller than kTallest times the lump:
/// what a press would drive beyond that stays in its ring, which a hand feels as clay that does not
/// give way. Allocates only when made; one thread.
class Volume {
 public:
  static constexpr double kThickest = 2.0;
  static constexpr double kTallest = 3.0;
  /// How far clay may rise: a row's thickness, as a multiple of a fresh lump's, and the pot's
  /// height, as a multiple of the lump's. > 1.
  struct Limits {
    double thickest = kThickest;
    double tallest = kTallest;
  };
  /// Measures `clay`, which keeps its areas from now on.
  explicit Volume(Clay& clay) : Volume(clay, Limits{}) {}
  Volume(Clay& clay, const Limits& limits);

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Volume make(const Effects&, Clay& clay) { return Volume(clay); }
  void run(const StageWork& work) noexcept { keep(work.clay, work.tick.seconds); }

  /// Stage 6 of the pipeline: rows that lost area since the last call gain height, as far as they
  /// may; rows that were pressed down, or may not grow, gain girth, as many as make 16384 elements
  /// a millisecond or a hundredth of all rows, the rest in the next calls: none waits for more than
  /// 0.1 s; what a tool cut off is gone. O(rows changed, rows above them); O(sectors) for each row
  /// that gains girth, and for one in 64 of the others, which is measured anew.
  void keep(Clay& clay, double seconds) noexcept;
  /// `clay` was laid anew: measures it again, `element_budget` elements a call (at least a row);
  /// true once all is done.
  bool measure_some(Clay& clay, int element_budget) noexcept;

  /// How much clay there is in step `step` (clay::History::depth()) as it begins: what is still on
  /// its way to its rows counts. The last kSteps are kept. O(rows).
  void note_step(const Clay& clay, std::uint64_t step) noexcept;
  /// `clay` was taken back to the beginning of `step`, and measured. Its rows may be of some ticks
  /// apart, and what was on its way is not in them: all are given the same share more, or less, so
  /// that together they hold what was noted; keep() then raises them. O(rows).
  void return_to(Clay& clay, std::uint64_t step) noexcept;

  double of_row(int j) const { return volume_[static_cast<std::size_t>(j)]; }  ///< m^3
  /// Row `j` gives `volume` m^3 to row `to`, or takes it where negative; keep() then raises and
  /// lowers them.
  void give(Clay& clay, int j, int to, double volume) noexcept;
  /// Rows that are thicker than `times` a fresh lump's, from those that keep() has raised: the
  /// lowest at or above `from`, or else below it; -1 where there is none. It is then asked no more,
  /// until it is raised anew.
  int take_thick(const Clay& clay, double times, int from) noexcept;
  void ask_again(int j) noexcept { raised_.add(j); }
  void row_divided(const Clay& clay, const RowDivided& divided) noexcept;
  void rows_joined(const Clay& clay, const RowsJoined& joined) noexcept;
  void forget(Clay& clay, const Laid& laid) noexcept {
    if (!laid.fresh) return_to(clay, laid.step);
  }
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  bool pressed_down(const Clay& clay, int j) const noexcept;
  double widen(Clay& clay, int j, double area, double height) noexcept;

  static constexpr std::size_t kSteps = clay::History::kMostSteps;
  double sum(const Clay& clay) const noexcept;

  Limits limits_;
  std::vector<double> noted_;  // of the step n at n % kSteps, m^3
  std::vector<double> volume_;
  std::vector<double> thickness_;  // as keep() left them: what differs was pressed down since
  RowSet raised_;                  // rows to be asked whether they are too thick
  unsigned turn_ = 0;              // whose turn it is to be measured
  int widen_from_ = 0;             // rows pressed down below this wait for the next call
  int measured_to_ = 0;            // of measure_some()
};

/// Area of row `j` of a clay that keeps them, m^2: measured where it is not known. O(sectors) then.
double known_area(Clay& clay, int j) noexcept;

/// Row `j` with the middle of its wall `girth` times as far out, and the wall `thickness` times as
/// thick, >= 1 together: its area is girth * thickness times what it was, to a float's rounding. A
/// solid row takes the root of that product, and so does one whose hole would get smaller than
/// radius_min. Held to radius_max and wall_min; gives the factor of
/// the area that was possible. The clay keeps areas, and knows this row's. Marks dirty. O(sectors),
/// no allocation.
double reshape_row(Clay& clay, int j, double girth, double thickness) noexcept;

}  // namespace effects
}  // namespace onggi
