#pragma once

#include <cstdint>
#include <vector>

#include "engine/clay/clay.h"
#include "engine/contact/tool.h"
#include "engine/math/hash.h"

namespace onggi {

/// A taut wire's path through one tick, studio frame.
struct WireSweep {
  Vec3 from, to;       ///< Its middle, m.
  Vec3 along;          ///< Its direction; only the level part counts.
  double length = 0;   ///< m
  double angle = 0;    ///< The clay's angle as the tick ends, rad.
  double seconds = 0;  ///< > 0.
};

/// How one hand draws the wire.
struct WireHand {
  bool drawing = false;  ///< It started outside the clay.
  Vec3 way;              ///< From the axis to the start, level and across the wire; unit.
};

/// The slit of a wire under a pot. The wire is drawn level through the clay, at the height where it
/// first meets it. Each ray of that row is cut from outside inwards and from the axis outwards.
/// When the whole section is cut, the clay above is free. Not safe across threads.
class WireCut {
 public:
  explicit WireCut(int sectors);  ///< Allocates everything it will use.

  /// The force opposes the hand's motion, in proportion to the width of clay in front of the wire,
  /// as if a strip 2 mm wide were pressed by 2 mm at `stiffness` (N/m^3). A hand that begins within
  /// the clay cuts nothing until it has been outside. No allocation; O(sectors).
  Press draw(const Clay& clay, const WireSweep& sweep, WireHand& hand, double stiffness) noexcept;
  /// Resets it for a new lump.
  void forget() noexcept;

  bool begun() const { return begun_; }
  bool free() const { return share_ >= 1.0; }
  double share() const { return share_; }    ///< Share of the section that is cut, 0..1.
  double height() const { return height_; }  ///< Height of the slit, m; valid once begun.
  void add_to(StateHash& hash) const;

 private:
  void cut(const Clay& clay, int row, const WireSweep& sweep, Vec3 way) noexcept;
  int samples_in_clay(const Clay& clay, int row, const WireSweep& sweep, Vec3 way,
                      double& step) const noexcept;

  std::vector<float> from_outside_, from_axis_;  // each ray is cut inwards to, and outwards to, m
  bool begun_ = false;
  double height_ = 0.0;
  double share_ = 0.0;
};

}  // namespace onggi
