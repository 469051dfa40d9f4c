#pragma once

#include <vector>

#include "engine/clay/clay.h"
#include "engine/effects/effect_field.h"
#include "engine/math/hash.h"

namespace onggi {

/// Clay is incompressible: what leaves a row's cross-section raises the row, what presses a row
/// down widens it. Pulling up the wall makes the pot taller and thinner. It has no numbers to set.
struct VolumeDef {
  static constexpr const char* kName = "volume";
  static std::span<const EffectField<VolumeDef>> fields() { return {}; }
};

namespace effects {

/// How much clay every row holds, and the heights that follow from it: h = V / A. Allocates only
/// when made; one thread.
class Volume {
 public:
  /// Measures `clay`, which keeps its areas from now on.
  explicit Volume(Clay& clay);

  /// Stage 6 of the pipeline: rows that lost area since the last call gain height; rows that were
  /// pressed down gain girth, as many as make 16384 elements a millisecond or a hundredth of all
  /// rows, the rest in the next calls: none waits for more than 0.1 s; what a tool cut off is gone.
  /// O(rows changed, rows above them); O(sectors) for each row pressed down, and for one in 64 of
  /// the others, which is measured anew.
  void keep(Clay& clay, double seconds) noexcept;
  /// `clay` was laid anew: measures it again, `element_budget` elements a call (at least a row);
  /// true once all is done.
  bool measure_some(Clay& clay, int element_budget) noexcept;

  double of_row(int j) const { return volume_[static_cast<std::size_t>(j)]; }  ///< m^3
  /// Row `j` gives `volume` m^3 to row `to`, or takes it where negative; keep() then raises and
  /// lowers them.
  void give(Clay& clay, int j, int to, double volume) noexcept;
  void add_to(StateHash& hash, Clay& clay) const;

 private:
  bool pressed_down(const Clay& clay, int j) const noexcept;

  std::vector<double> volume_;
  std::vector<double> thickness_;  // as keep() left them: what differs was pressed down since
  unsigned turn_ = 0;              // whose turn it is to be measured
  int widen_from_ = 0;             // rows pressed down below this wait for the next call
  int measured_to_ = 0;            // of measure_some()
};

/// Area of row `j` of a clay that keeps them, m^2: measured where it is not known. O(sectors) then.
double known_area(Clay& clay, int j) noexcept;

/// Row `j` with the middle of its wall `girth` times as far out, and the wall `thickness` times as
/// thick, >= 1 together: its area is girth * thickness times what it was, to a float's rounding. A
/// solid row takes the root of that product. Held to radius_max and wall_min; gives the factor of
/// the area that was possible. The clay keeps areas, and knows this row's. Marks dirty. O(sectors),
/// no allocation.
double reshape_row(Clay& clay, int j, double girth, double thickness) noexcept;

}  // namespace effects
}  // namespace onggi
