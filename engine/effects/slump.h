#pragma once

#include "engine/effects/building.h"
#include "engine/effects/moisture.h"
#include "engine/effects/round.h"
#include "engine/effects/row_stage.h"
#include "engine/effects/volume.h"

namespace onggi {

/// A pot that cannot carry its weight sags, and a pot that is spun too fast spreads: clay flows
/// where stress is above its yield strength (Bingham). Needs volume.
struct SlumpDef {
  double yield_stress = 6000.0;  ///< tau_y of plastic clay in shear, Pa, 100..1e6 (5 to 10 kPa; an
                                 ///< estimate from soils). Lower: pots must stay low. A straight
                                 ///< wall stands up to sqrt(3) tau_y / (density g): 0.54 m. The
                                 ///< same clay has WallsDef::bending_strength sqrt(3) tau_y.
  double viscosity = 1e4;   ///< Pa s above the yield stress, 10..1e8. Lower: a fall is quicker.
  double density = 1950.0;  ///< kg/m^3, 500..4000.
  double fall = 0.1;  ///< A pot counts as fallen when it sags by this share of its height within a
                      ///< few seconds, 0.01..0.9. Higher: the kiosk comforts the visitor later.

  static constexpr const char* kName = "slump";
  static std::span<const DefField<SlumpDef>> fields();
};

namespace effects {

/// Sinks the rows that yield, as fast as their neighbours let them. A sweep down from the rim finds
/// what yields. A sweep back up solves for what neighbours carry, and moves the clay by what it
/// flows in the time of both sweeps. Each lasts 25 ms, and on the finest grids the second lasts
/// longer (Round::lasting). So nothing is later than that, whatever the tick. A row that carries
/// its load does not move, and one that does not moves only until it does. A motion too small for a
/// float radius is kept until it is large enough. Asleep while nothing yields and nothing changes.
/// Allocates only when made.
class Slump {
 public:
  /// `room`: most rows.
  explicit Slump(int room)
      : ring_(static_cast<std::size_t>(room)), owed_(static_cast<std::size_t>(room)) {}

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Slump make(const Effects&, Clay& clay) { return Slump(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// Conditions around the clay.
  struct Around {
    const Moisture* moisture = nullptr;  ///< Null: dry.
    const MoistureDef* moisture_def = nullptr;
    double wheel_speed = 0.0;            ///< rad/s
    double seconds = 0.0;                ///< Of this tick.
    bool touched = false;                ///< A hand pressed clay in this tick, or a lump was laid.
    const Building* building = nullptr;  ///< Null: no joints,
    const BuildingDef* building_def = nullptr;  ///< and this too.
  };
  /// Stage 6 of the pipeline. Runs before Volume::keep(), which lowers the rows that this widens.
  void sink(const SlumpDef& def, Clay& clay, Volume& volume, const Around& around) noexcept;

  bool asleep() const { return asleep_; }
  /// How fast the rim sinks, m/s; 0 while the pot stands.
  double speed() const { return speed_; }
  /// It sagged by SlumpDef::fall within about kFallTime.
  bool fallen() const { return fallen_; }
  /// It has sagged by less than a tenth of that.
  bool stands() const { return stands_; }
  void row_added(const Clay&, const RowAdded& added) noexcept;
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined& joined) noexcept;
  /// Call for a new pot: it has not fallen.
  void forget(Clay&, const Laid&) noexcept;
  static constexpr double kFallTime = 3.0;  ///< s
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  // A row's flow, as logarithms of its growth.
  struct Flow {
    double girth = 0.0, thickness = 0.0;
    double shorter() const { return girth + thickness; }
  };
  // A row after the sweep down.
  struct Ring {
    Flow flow;           // its flow if the row below stands still,
    double below = 0.0;  // and the share of the row below's flow that it adds
    double room = 0.0;   // growth of area at which it carries its load, as a logarithm; for a row
                         // that stands, its spare strength as a negative share
  };
  enum class Sweep : std::uint8_t { ended, down, up };

  Ring flow_alone(const SlumpDef& def, const Clay& clay, const Volume& volume, const Around& around,
                  int j) const noexcept;
  void begin(const Clay& clay) noexcept;
  void sweep_down(const SlumpDef& def, Clay& clay, const Volume& volume, const Around& around,
                  int till) noexcept;
  void sweep_up(Clay& clay, int till) noexcept;
  void end(const SlumpDef& def, const Clay& clay) noexcept;
  // Couples a row's flow with the rows that the sweep has passed.
  Ring coupled(Clay& clay, int j, Ring ring) const noexcept;
  void move(Clay& clay, int j, const Flow& flow) noexcept;

  std::vector<Ring> ring_;
  std::vector<Flow> owed_;  // for every row: flow still too small to move it
  Flow passed_;             // of the row that the sweep up passed last
  Sweep sweep_ = Sweep::ended;
  Round round_;
  int next_ = 0;          // next row of this sweep
  double above_ = 0.0;    // m^3 above that row
  double seconds_ = 0.0;  // s, length of both sweeps
  double sunk_ = 0.0;     // m, in both sweeps
  double speed_ = 0.0;
  double sagged_ = 0.0;  // m, recently
  bool fallen_ = false;
  bool stands_ = true;
  bool yielded_ = false;  // in these sweeps
  bool stirred_ = false;  // something changed in them
  bool asleep_ = false;
  double calm_speed_ = 0.0;    // the wheel's, when nothing yielded
  double calm_wetness_ = 0.0;  // the mean wetness, when nothing yielded,
  double calm_soaked_ = 0.0;   // and Moisture::soaked()
};

}  // namespace effects
}  // namespace onggi
