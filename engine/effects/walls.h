#pragma once

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
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
  double bending_strength = 0.0;  ///< sigma, Pa, 0..1e6: pull or push along one way at which clay
                                  ///< yields, as in a wall that bends under a hand. sqrt(3) times
                                  ///< SlumpDef::yield_stress, which is in shear. Higher: thin walls
                                  ///< are felt as harder. 0: a wall bears any push.

  static constexpr const char* kName = "walls";
  static std::span<const DefField<WallsDef>> fields();
};

namespace effects {

/// Walls of `def` can tear.
inline bool tears(const WallsDef& def) { return def.tear_thickness > 0.0 || def.tear_strain > 0.0; }

/// How much a hand at `holding` holds the wall against one that presses it at `pressing`, on the
/// other face: 1 face to face, 0 beyond `def.support` along the wall. m, any one frame about the
/// axis.
double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept;

/// What a wall bears of a hand's push before it bends, N: the plastic collapse load of a plate that
/// is held all round under a point (four pi times its plastic moment, sigma t^2 / 4; Save,
/// Massonnet & de Saxce, Plastic Limit Analysis of Plates, Shells and Disks, 1997). `strength` is
/// the share that water leaves of the strength. Rises with the square of the thickness. A free
/// rim, which bears less, is not modelled.
double wall_bears(const WallsDef& def, double thickness, double strength) noexcept;

/// What a hand feels of a push of `normal` N on a wall that bears `bears` (N, infinite where the
/// clay is solid), of which `held` (0..normal) rests on the other hand: held + W / sqrt(1 + (W /
/// P)^2), W = normal - held. Wall and clay under the finger give way one behind the other, so the
/// wall gives never more than P, and far below it all of W. Nowhere steeper than `normal` itself,
/// in either of the two. N.
double wall_push(double normal, double bears, double held) noexcept;

/// Mean thickness of the wall at `at` (clay frame, m) within 8 mm to each side, m: of the rows
/// above and below it by the distance of their middles, and of elements that are in part within by
/// that part, so that it has no steps. Infinite at the floor's top and below. O(elements there).
double wall_thickness(const Clay& clay, Vec3 at) noexcept;

/// How much of a push at `height` (m) the wall has to bear itself, 0..1: from 0 where the clay is
/// solid smoothly to 1 at 8 mm above it, where the foot holds the wall no more.
double clear_of_foot(const Clay& clay, double height) noexcept;

}  // namespace effects
}  // namespace onggi
