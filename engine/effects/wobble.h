#pragma once

#include <array>

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/clay/wall_side.h"
#include "engine/effects/round.h"
#include "engine/effects/row_stage.h"
#include "engine/math/hash.h"
#include "engine/math/vec.h"

namespace onggi {

/// A lump off the middle of the wheel. It beats against the hand at every turn until steady
/// pressing has centred it.
struct WobbleDef {
  double off_centre = 0.004;    ///< m, 0..0.03: offset of a fresh lump. Higher: a beginner's throw.
  double centring_time = 0.05;  ///< s, 0.002..60: time in which a press of 1 N removes two thirds
                                ///< of the offset under the hand. Higher: a heavier lump.
  double reach = 0.03;          ///< m, 0.001..1: how far up and down a hand moves the lump with it.

  static constexpr const char* kName = "wobble";
  static std::span<const DefField<WobbleDef>> fields();
};

namespace effects {

/// A ring's middle relative to the axis, m, clay's frame (x and z).
struct OffCentre {
  double x = 0.0, z = 0.0;
};
/// Offset of row `j`: the first harmonic of its outline. O(sectors).
OffCentre off_centre_of(const Clay& clay, int j) noexcept;

/// Moves row `j`, whose faces are circles about the axis, by `off`. O(sectors).
void lay_off_centre(Clay& clay, int j, OffCentre off) noexcept;

/// A hand's press in this tick.
struct CentringHand {
  Vec3 at;              ///< Clay frame, m.
  double normal = 0.0;  ///< N
  WallSide side = WallSide::outside;
};

/// Centres rows under the hands. A press is gathered while the rows near the hand take turns. Then
/// each row gets the same share: a row with another share would stand out as a disc. A round lasts
/// 20 ms, longer on the finest grids (Round::lasting). So a press waits at most two rounds and 20
/// ms. A press worth less than a fifty-thousandth of the offset is kept for the next round.
///
/// Turns go through many low strips at once (2 mm, or a 48th of what the hand reaches), up in one
/// strip and down in the next. So under a tool some row moves in each tick. Moving all of them
/// within a few ticks would be felt as a blow, fifty times a second. No allocation; one thread.
class Wobble {
 public:
  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Wobble make(const Effects&, Clay&) { return {}; }
  /// A fresh lump lies off the middle.
  static void lay_row(const Effects& def, Clay& clay, int j) noexcept;
  void run(const StageWork& work) noexcept;

  /// Stage 6.4: adds what hand `n` of kMostHands does in a tick of `seconds`. O(1).
  void press(std::size_t n, const CentringHand& hand, double seconds) noexcept;
  /// Stage 6.4: pushes rings near a hand towards the middle, away from a hand outside and towards
  /// one inside, by a share of their offset on the hand's side. The offset never grows. O(sectors)
  /// a row.
  void centre(const WobbleDef& def, Clay& clay, double seconds) noexcept;
  void row_added(const Clay&, const RowAdded&) noexcept {}
  void row_divided(const Clay&, const RowDivided& divided) noexcept;
  void rows_joined(const Clay&, const RowsJoined& joined) noexcept;
  void forget(Clay&, const Laid&) noexcept {
    sweeps_ = {};
    beat_ = {};
  }
  void add_to(StateHash& hash, Clay&) const;

 private:
  static constexpr std::size_t kDirections = 16;
  struct Push {
    double x = 0.0, z = 0.0, impulse = 0.0;  // sums over ticks: impulse (N s), and impulse times
                                             // direction
  };
  struct Gathered {
    std::array<Push, kDirections> push;
    double impulse = 0.0;  // N s
    double raised = 0.0;   // N s m: impulse times the hand's height
  };
  static constexpr int kMostStrips = 48;
  struct Sweep {
    Gathered next, now;
    double height = 0.0;  // m, the hand's
    int strips = 0;
    std::array<int, kMostStrips + 1> bound{};  // strip k has rows from bound k to bound k + 1
    std::array<int, kMostStrips> edge{};       // progress of the strip's turns, up or down
    Round round;
  };
  static void begin(const WobbleDef& def, const Clay& clay, Sweep& sweep) noexcept;
  void go_on(const WobbleDef& def, Clay& clay, Sweep& sweep, double seconds) noexcept;
  void centre_row(const WobbleDef& def, Clay& clay, const Sweep& sweep, int j) noexcept;

  std::array<Sweep, kMostHands> sweeps_;
  Round beat_;  // starts all rounds, so that a hand's arrival time does not matter
};

}  // namespace effects
}  // namespace onggi
