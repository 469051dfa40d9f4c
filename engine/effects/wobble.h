#pragma once

#include "engine/clay/clay.h"
#include "engine/contact/wall_side.h"
#include "engine/effects/effect_field.h"
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
  static std::span<const EffectField<WobbleDef>> fields();
};

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

/// Centres rows under the hands. No allocation; one thread.
class Wobble {
 public:
  /// Stage 6.4: the rings near the hand are pushed towards the middle, away from a hand outside and
  /// towards one inside, by a share of what they are off on its side: they come nearer to it or
  /// stay. The rows take turns. O(sectors) a row, at most 2048 elements or four rows a tick.
  void centre(const WobbleDef& def, Clay& clay, const CentringHand& hand, double seconds) noexcept;
  void add_to(StateHash& hash) const;

 private:
  unsigned turn_ = 0;
};

}  // namespace onggi
