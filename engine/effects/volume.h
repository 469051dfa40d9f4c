#pragma once

#include <cstdint>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/clay/history.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"

namespace onggi {

/// Clay is incompressible: a row that loses cross-section gets higher, and a row that is pressed
/// down gets wider. Pulling up the wall makes the pot taller and thinner. It has no settings.
struct VolumeDef {
  static constexpr const char* kName = "volume";
  static std::span<const DefField<VolumeDef>> fields() { return {}; }
};

namespace effects {

/// The clay in every row, and the heights that follow: h = V / A. No row gets thicker than
/// kThickest times a fresh lump's, and no pot taller than kTallest times the lump. Clay that a
/// press would drive beyond that stays in its ring, and a hand feels clay that does not yield.
/// Allocates only when made; one thread.
class Volume {
 public:
  static constexpr double kThickest = 2.0;
  static constexpr double kTallest = 3.0;
  /// How far clay may rise: a row's thickness as a multiple of a fresh lump's, and the pot's height
  /// as a multiple of the lump's. > 1.
  struct Limits {
    double thickest = kThickest;
    double tallest = kTallest;
  };
  /// Measures `clay`, and makes it keep its areas from now on.
  explicit Volume(Clay& clay) : Volume(clay, Limits{}) {}
  Volume(Clay& clay, const Limits& limits);

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Volume make(const Effects& def, Clay& clay);
  void run(const StageWork& work) noexcept;

  /// Stage 6 of the pipeline. Rows that lost area since the last call get higher, as far as they
  /// may. Rows that were pressed down, or may not get higher, get wider: 16384 elements a
  /// millisecond or a hundredth of all rows per call, the rest in later calls, within 0.1 s. Clay
  /// that a tool cut off is gone; `prints`, if any, are told. O(rows changed, rows above them);
  /// O(sectors) for each row that gets wider, and for one in 64 of the others, which is measured
  /// again.
  void keep(Clay& clay, double seconds, Prints* prints = nullptr) noexcept;
  /// `clay` was laid anew: measures it again, `element_budget` elements a call (at least a row).
  /// True when done.
  bool measure_some(Clay& clay, int element_budget) noexcept;

  /// Notes how much clay there is as step `step` (clay::History::depth()) begins, including clay on
  /// its way between rows. Keeps the last kSteps. O(rows).
  void note_step(const Clay& clay, std::uint64_t step) noexcept;
  /// `clay` was taken back to the beginning of `step`, and measured. Its rows may be some ticks
  /// apart and lack the clay that was on its way. So every row gains or loses the same share, and
  /// the total is what was noted. keep() then sets the heights. O(rows).
  void return_to(Clay& clay, std::uint64_t step) noexcept;

  double of_row(int j) const { return volume_[static_cast<std::size_t>(j)]; }  ///< m^3
  double of_all(const Clay& clay) const noexcept { return sum(clay); }         ///< m^3; O(rows).
  /// Moves `volume` m^3 from row `j` to row `to`; a negative volume moves the other way. keep()
  /// then sets their heights.
  void give(Clay& clay, int j, int to, double volume) noexcept;
  /// The lowest row at or above `from`, else the lowest below it, that is thicker than `times` a
  /// fresh lump's, among the rows that keep() has raised. -1 if there is none. A row is returned
  /// only once until it is raised again.
  int take_thick(const Clay& clay, double times, int from) noexcept;
  void ask_again(int j) noexcept { raised_.add(j); }
  void row_added(const Clay& clay, const RowAdded& added) noexcept;
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
  std::vector<double> noted_;  // of step n at n % kSteps, m^3
  std::vector<double> volume_;
  std::vector<double> thickness_;  // after keep(): a row that differs was pressed down since
  RowSet raised_;                  // rows to check for thickness
  unsigned turn_ = 0;              // which rows are measured next
  int widen_from_ = 0;             // pressed rows below this wait for the next call
  int measured_to_ = 0;            // progress of measure_some()
};

/// Area of row `j` of a clay that keeps areas, m^2. Measures it if unknown; O(sectors) then.
double known_area(Clay& clay, int j) noexcept;

/// Scales row `j`: the middle of its wall by `girth`, its wall's thickness by `thickness`, with a
/// product >= 1. Its area grows by that product, to a float's rounding. A solid row, or one whose
/// hole would get smaller than radius_min, scales both by the root of the product instead. Keeps
/// within radius_max and wall_min; returns the factor of area that was possible. The clay must keep
/// areas and know this row's. Marks dirty. O(sectors), no allocation.
double reshape_row(Clay& clay, int j, double girth, double thickness) noexcept;

}  // namespace effects
}  // namespace onggi
