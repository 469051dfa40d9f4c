#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/math/hash.h"

namespace onggi {

/// Water in the clay: a sponge brings it, the air removes it. Wet clay yields sooner, drags less
/// and carries less. Wetness 0 is plastic clay from the bag, 1 is dripping slip.
struct MoistureDef {
  double wetting_time = 0.6;  ///< s to soak while the sponge is held, 0.05..60.
  double drying_time = 60.0;  ///< s, time constant, 1..36000.
  double fire_time = 10.0;    ///< Likewise while a fire hangs inside (Hands::fire).
  double softening = 0.5;     ///< Relaxation time when dripping wet, as a share of the dry one,
                              ///< 0.05..1. Lower: wet clay yields at a touch.
  /// Yield strength and viscosity when dripping wet, as a share of the dry ones, 0.005..1; in
  /// between, powers of this share. Strength falls about 35 times from the plastic to the liquid
  /// limit. Used by slump.
  double weakening = 0.03;
  double air = 0.0;  ///< Wetness towards which the clay dries, 0..1: a damp room leaves it wet.
  double sponge_height = 0.0;  ///< m, 0..1: height of the band that a sponge wets, centred on the
                               ///< sponge. 0: the pot is equally wet everywhere, and rows have no
                               ///< wetness of their own. Fixed when the scene is made.

  static constexpr const char* kName = "moisture";
  static std::span<const DefField<MoistureDef>> fields();
};

namespace effects {

/// Relaxation time of clay of `wetness`, as a share of the dry clay's.
double softness(const MoistureDef& def, double wetness) noexcept;
/// Yield strength and viscosity of clay of `wetness`, as a share of the dry clay's.
double strength(const MoistureDef& def, double wetness) noexcept;

/// How wet a pot is, as a whole or by row. Uses exact exponentials, so the tick's length does not
/// matter. Allocates only when made; one thread.
class Moisture {
 public:
  /// Dry clay of `rows` rows, with space for `room`.
  Moisture(const MoistureDef& def, int rows, int room);
  Moisture(const MoistureDef& def, int rows) : Moisture(def, rows, rows) {}

  /// Stage 3 of the pipeline. If `sponge`, a sponge is at each of `heights` (m, on the rows of
  /// `clay`; at most two); none means the whole pot. A row under two sponges soaks as under one.
  /// Soaked rows also dry. `fire`: one hangs inside. O(rows under the sponge).
  void soak_or_dry(const MoistureDef& def, const Clay& clay, double seconds, bool sponge,
                   std::span<const double> heights, bool fire = false) noexcept;

  /// Mean over the rows, 0..1.
  double mean() const { return mean_; }
  /// Grows by at least as much as any row is wetted by a sponge: what sees it grow by less than x
  /// need not look for a row that is wetter by x. 0 without Moisture by row.
  double soaked() const { return soaked_; }
  /// Of a stored row (Clay::stored), 0..1.
  double of_row(int stored) const {
    return row_.empty() ? mean_ : air_ + row_[static_cast<std::size_t>(stored)] * decay_;
  }
  /// The stored row `to` came at the top, and holds `share` (0..1) of the clay: as wet as
  /// `wetness`.
  void row_added(const Clay& clay, int to, double wetness, double share) noexcept;
  /// `from` was divided and the stored row `to` is half of it, or `from` was joined with `to`.
  /// `share` (0..1): the part of `to` in both. `clay` is the clay afterwards.
  void row_divided(const Clay& clay, int from, int to) noexcept;
  void rows_joined(const Clay& clay, int from, int to, double share) noexcept;
  /// Call after rows were added or removed. O(rows).
  void count_rows(const Clay& clay) noexcept;
  /// Wetness of the row nearest to `height` (m).
  double at(const Clay& clay, double height) const;
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  // A sponge's effect in a tick on a row that also dried: (w - air) becomes less (w - air) + more.
  struct Soaked {
    double less = 1.0, more = 0.0;
  };
  void soak_row(int stored, const Soaked& soaked) noexcept;
  void soak_bands(const Clay& clay, double reach, std::span<const double> heights,
                  const Soaked& soaked) noexcept;

  // All rows dry at the same rate, so one factor serves all: a stored row is air + row_[] * decay_.
  std::vector<double> row_;
  double decay_ = 1.0;
  double air_ = 0.0;
  double mean_ = 0.0;
  double soaked_ = 0.0;      // adds up, over ticks, what the most wetted row took in
  double most_taken_ = 0.0;  // in this tick
  int rows_ = 0;
};

}  // namespace effects
}  // namespace onggi
