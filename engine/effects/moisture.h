#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/math/hash.h"

namespace onggi {

/// Water in the clay: a sponge brings it, the air takes it. Wet clay gives way sooner, drags less,
/// and carries less. Wetness 0 is plastic clay as it comes from the bag, 1 is dripping slip.
struct MoistureDef {
  double wetting_time = 0.6;  ///< s to soak while the sponge is held, 0.05..60.
  double drying_time = 60.0;  ///< s, time constant, 1..36000.
  double softening = 0.5;     ///< Relaxation time when dripping wet, as a share of the dry one,
                              ///< 0.05..1. Lower: wet clay gives way at a touch.
  double weakening = 0.03;    ///< Yield strength and viscosity when dripping wet, as a share of the
                              ///< dry ones, 0.005..1; in between by powers of it. Strength falls
                              ///< about 35 times from the plastic to the liquid limit. For slump.
  double air = 0.0;  ///< Wetness that the clay dries towards, 0..1: a damp room leaves it wet.
  double sponge_height = 0.0;  ///< m, 0..1: height of the band that a sponge wets, about itself. 0:
                               ///< all of the pot alike, and no row has a wetness of its own. Fixed
                               ///< when the scene is made.

  static constexpr const char* kName = "moisture";
  static std::span<const DefField<MoistureDef>> fields();
};

namespace effects {

/// Relaxation time of clay of `wetness`, as a share of the dry clay's.
double softness(const MoistureDef& def, double wetness) noexcept;
/// Yield strength and viscosity likewise.
double strength(const MoistureDef& def, double wetness) noexcept;

/// How wet a pot is, all of it alike or row by row. Exact exponentials, so that the tick's length
/// does not matter. Allocates only when made; one thread.
class Moisture {
 public:
  /// Dry clay of `rows` rows, with room for `room`.
  Moisture(const MoistureDef& def, int rows, int room);
  Moisture(const MoistureDef& def, int rows) : Moisture(def, rows, rows) {}

  /// Stage 3 of the pipeline. With `sponge`, it is held at `heights` (m, on the rows of `clay`; two
  /// at the most); none means the whole pot. A row under two sponges soaks as under one. The air
  /// dries what is soaked, too. O(rows under the sponge).
  void soak_or_dry(const MoistureDef& def, const Clay& clay, double seconds, bool sponge,
                   std::span<const double> heights) noexcept;

  /// Mean over the rows, 0..1.
  double mean() const { return mean_; }
  /// Of a stored row (Clay::stored), 0..1.
  double of_row(int stored) const {
    return row_.empty() ? mean_ : air_ + row_[static_cast<std::size_t>(stored)] * decay_;
  }
  /// The stored row `to` is half of what `from` was, or `from` has taken it up, and it was `share`
  /// (0..1) of both. `clay` is as it is after that.
  void row_divided(const Clay& clay, int from, int to) noexcept;
  void rows_joined(const Clay& clay, int from, int to, double share) noexcept;
  /// Rows have come and gone. O(rows).
  void count_rows(const Clay& clay) noexcept;
  /// At `height` m, the nearest row's.
  double at(const Clay& clay, double height) const;
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  // What a sponge makes in a tick of a row that has dried in it: w - air becomes less (w - air) +
  // more.
  struct Soaked {
    double less = 1.0, more = 0.0;
  };
  void soak_row(int stored, const Soaked& soaked) noexcept;
  void soak_bands(const Clay& clay, double reach, std::span<const double> heights,
                  const Soaked& soaked) noexcept;

  // All rows dry at one pace, so that one factor does for them: a stored row is air + row_[] *
  // decay_.
  std::vector<double> row_;
  double decay_ = 1.0;
  double air_ = 0.0;
  double mean_ = 0.0;
  int rows_ = 0;
};

}  // namespace effects
}  // namespace onggi
