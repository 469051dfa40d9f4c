#pragma once

#include "engine/effects/moisture.h"
#include "engine/effects/round.h"
#include "engine/effects/row_stage.h"
#include "engine/effects/volume.h"

namespace onggi {

/// A pot that cannot carry its own weight sags, and one that is spun too fast spreads: clay flows
/// where stress is above its yield strength (Bingham). Needs volume.
struct SlumpDef {
  double yield_stress = 6000.0;  ///< tau_y of plastic clay in shear, Pa, 100..1e6 (5 to 10 kPa; an
                                 ///< estimate from soils). Lower: pots must stay low. A straight
                                 ///< wall stands up to sqrt(3) tau_y / (density g): 0.54 m. The
                                 ///< same clay has WallsDef::bending_strength sqrt(3) tau_y.
  double viscosity = 1e4;   ///< Pa s above the yield stress, 10..1e8. Lower: a fall is quicker.
  double density = 1950.0;  ///< kg/m^3, 500..4000.
  double fall =
      0.1;  ///< Share of its height that a pot sags by within a few seconds when it counts
            ///< as fallen, 0.01..0.9. Higher: the kiosk waits longer with kind words.

  static constexpr const char* kName = "slump";
  static std::span<const DefField<SlumpDef>> fields();
};

namespace effects {

/// Sinks the rows that yield, as fast as their neighbours let them: a sweep from the rim down finds
/// what yields, one back up solves for what neighbours carry and moves the clay, by what it flows
/// in as long as both sweeps last: 25 ms each, and on the finest grids the second longer
/// (Round::lasting). So nothing is later than that, whatever the tick. A row that carries its load
/// is not moved, and one that does not is moved no farther than until it does. Less than a row's
/// radii can hold in floats is kept until it is enough. Asleep while nothing yields and nothing
/// changes. Allocates only when made.
class Slump {
 public:
  /// `room`: rows at the most.
  explicit Slump(int room)
      : ring_(static_cast<std::size_t>(room)), owed_(static_cast<std::size_t>(room)) {}

  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Slump make(const Effects&, Clay& clay) { return Slump(clay.room()); }
  void run(const StageWork& work) noexcept;

  /// What the clay stands in.
  struct Around {
    const Moisture* moisture = nullptr;  ///< Null: dry.
    const MoistureDef* moisture_def = nullptr;
    double wheel_speed = 0.0;  ///< rad/s
    double seconds = 0.0;      ///< Of this tick.
    bool touched = false;      ///< A hand pressed clay in this tick, or a lump was put on.
  };
  /// Stage 6 of the pipeline, before Volume::keep(), which lowers the rows that this widens.
  void sink(const SlumpDef& def, Clay& clay, Volume& volume, const Around& around) noexcept;

  bool asleep() const { return asleep_; }
  /// How fast the rim sinks, m/s; 0 while the pot stands.
  double speed() const { return speed_; }
  /// It sagged by SlumpDef::fall within about kFallTime.
  bool fallen() const { return fallen_; }
  /// It has sagged by less than a tenth of that.
  bool stands() const { return stands_; }
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined& joined) noexcept;
  /// The pot is another one: it has not fallen.
  void forget(Clay&, const Laid&) noexcept;
  static constexpr double kFallTime = 3.0;  ///< s
  void add_to(StateHash& hash, const Clay& clay) const;

 private:
  // What a row does, as logarithms of its growth.
  struct Flow {
    double girth = 0.0, thickness = 0.0;
    double shorter() const { return girth + thickness; }
  };
  // A row as the sweep down leaves it.
  struct Ring {
    Flow flow;           // what it does where the row below stands still,
    double below = 0.0;  // and the share in which it also does as that row does
    double room = 0.0;   // growth of its area with which it carries its load, as a logarithm; of a
                         // row that stands, what it could bear besides, as a negative share
  };
  enum class Sweep : std::uint8_t { ended, down, up };

  Ring alone(const SlumpDef& def, const Clay& clay, const Volume& volume, const Around& around,
             int j) const noexcept;
  void begin(const Clay& clay) noexcept;
  void sweep_down(const SlumpDef& def, Clay& clay, const Volume& volume, const Around& around,
                  int till) noexcept;
  void sweep_up(Clay& clay, int till) noexcept;
  void end(const SlumpDef& def, const Clay& clay) noexcept;
  // What a row does beside those that the sweep has passed.
  Ring beside(Clay& clay, int j, Ring ring) const noexcept;
  void move(Clay& clay, int j, const Flow& flow) noexcept;

  std::vector<Ring> ring_;
  std::vector<Flow> owed_;  // to every row, not enough yet to move it
  Flow passed_;             // by the row that the sweep up passed last
  Sweep sweep_ = Sweep::ended;
  Round round_;
  int next_ = 0;          // row of this sweep
  double above_ = 0.0;    // m^3 over that row
  double seconds_ = 0.0;  // that both sweeps last
  double sunk_ = 0.0;     // m in them
  double speed_ = 0.0;
  double sagged_ = 0.0;  // m, of late
  bool fallen_ = false;
  bool stands_ = true;
  bool yielded_ = false;  // in these sweeps
  bool stirred_ = false;  // something changed in them
  bool asleep_ = false;
  double calm_speed_ = 0.0;    // the wheel's as it was when nothing yielded
  double calm_wetness_ = 0.0;  // likewise
};

}  // namespace effects
}  // namespace onggi
