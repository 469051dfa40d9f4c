#pragma once

#include "engine/effects/effect_field.h"
#include "engine/math/vec.h"

namespace onggi {

/// A wall is held from the other side or it gives way as a whole. Pressed where a second hand holds
/// it, it thins; pressed alone, both faces move and the ring keeps its area: collared it gets
/// thicker, opened it gets thinner. Without this effect every press thins the wall.
struct WallsDef {
  double support = 0.03;  ///< m, 0.001..0.2: how far along the wall a hand still holds it against
                          ///< another, fading to nothing. Higher: hands need not face each other.
  double tear_thickness = 0.0;  ///< m, 0..0.02: a wall that gets thinner tears (tearing.h). 0: none
                                ///< does. Otherwise more than the clay's wall_min.
  double tear_strain = 0.0;  ///< 0..10: share by which a ring may get wider than the lump was; more
                             ///< tears it. 0: none does. Lower: bowls must be opened with care.

  static constexpr const char* kName = "walls";
  static std::span<const EffectField<WallsDef>> fields();
};

namespace effects {

/// Walls of `def` can tear.
inline bool tears(const WallsDef& def) { return def.tear_thickness > 0.0 || def.tear_strain > 0.0; }

/// How much a hand at `holding` holds the wall against one that presses it at `pressing`, on the
/// other face: 1 face to face, 0 beyond `def.support` along the wall. m, any one frame about the
/// axis.
double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept;

}  // namespace effects
}  // namespace onggi
