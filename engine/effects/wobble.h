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

/// A lump that was not thrown in the middle of the wheel: it beats against the hand at every turn
/// until steady pressing has centred it.
struct WobbleDef {
  double off_centre = 0.004;    ///< m, 0..0.03: of a fresh lump. Higher: a beginner's throw.
  double centring_time = 0.05;  ///< s, 0.002..60: how soon a press of 1 N takes away two thirds of
                                ///< it under the hand; harder is sooner. Higher: a heavier lump.
  double reach = 0.03;          ///< m, 0.001..1: how far up and down a hand takes the lump along.

  static constexpr const char* kName = "wobble";
  static std::span<const DefField<WobbleDef>> fields();
};

namespace effects {

/// How far a ring's middle is from the axis, m, in the clay's frame (x and z).
struct OffCentre {
  double x = 0.0, z = 0.0;
};
/// Of the outline of row `j`: its first harmonic. O(sectors).
OffCentre off_centre_of(const Clay& clay, int j) noexcept;

/// Lays row `j`, whose faces are circles about the axis, `off` the middle. O(sectors).
void lay_off_centre(Clay& clay, int j, OffCentre off) noexcept;

/// How a hand presses, in this tick.
struct CentringHand {
  Vec3 at;              ///< Clay frame, m.
  double normal = 0.0;  ///< N
  WallSide side = WallSide::outside;
};

/// Centres rows under the hands. A press is gathered while the rows near the hand take turns, and
/// then given to each of them alike: a row that got another share than its neighbour would stand
/// out as a disc. A round of turns lasts 20 ms, on the finest grids longer (Round::lasting): no
/// press waits for more than two and 20 ms. One that is worth less than a fifty-thousandth of what
/// a ring is off is kept for the next.
///
/// Turns go through many low strips at once (2 mm, or a 48th of what the hand reaches), up in one
/// and down in the next, so that under a tool some row moves in each tick: all of them within a few
/// ticks would be a blow, fifty times a second. Neighbours follow each other all the same. No
/// allocation; one thread.
class Wobble {
 public:
  static constexpr bool kAsksMoves = false;
  static bool wanted(const Effects& def);
  static Wobble make(const Effects&, Clay&) { return {}; }
  /// A fresh lump lies off the middle.
  static void lay_row(const Effects& def, Clay& clay, int j) noexcept;
  void run(const StageWork& work) noexcept;

  /// Stage 6.4: what hand `n` of kMostHands does in a tick of `seconds`. O(1).
  void press(std::size_t n, const CentringHand& hand, double seconds) noexcept;
  /// Then: the rings near a hand are pushed towards the middle, away from a hand outside and
  /// towards one inside, by a share of what they are off on its side: they come nearer to it or
  /// stay. O(sectors) a row.
  void centre(const WobbleDef& def, Clay& clay, double seconds) noexcept;
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
    double x = 0.0, z = 0.0, impulse = 0.0;  // sums over ticks, N s: of it times where to, and it
  };
  struct Gathered {
    std::array<Push, kDirections> push;
    double impulse = 0.0;  // N s
    double raised = 0.0;   // N s m: that times the hand's height
  };
  static constexpr int kMostStrips = 48;
  struct Sweep {
    Gathered next, now;
    double height = 0.0;  // m, of the hand
    int strips = 0;
    std::array<int, kMostStrips + 1> bound{};  // rows of strip k: from bound k to bound k + 1
    std::array<int, kMostStrips> edge{};       // how far its turns have come, up or down
    Round round;
  };
  static void begin(const WobbleDef& def, const Clay& clay, Sweep& sweep) noexcept;
  void go_on(const WobbleDef& def, Clay& clay, Sweep& sweep, double seconds) noexcept;
  void centre_row(const WobbleDef& def, Clay& clay, const Sweep& sweep, int j) noexcept;

  std::array<Sweep, kMostHands> sweeps_;
  Round beat_;  // by which all of them begin, so that it does not matter when a hand came
};

}  // namespace effects
}  // namespace onggi
