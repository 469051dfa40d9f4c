#pragma once

#include "engine/base/def_field.h"
#include "engine/clay/clay.h"
#include "engine/effects/moisture.h"
#include "engine/math/vec.h"

namespace onggi {

/// A wall is held from the other side, or it moves as a whole. Where a second hand holds it, a
/// press thins it. Pressed alone, both faces move and the ring keeps its area: collaring thickens
/// it, opening thins it. Without this effect every press thins the wall.
struct WallsDef {
  /// m, 0.001..0.2: distance along the wall within which a hand supports it against another, fading
  /// to nothing. Higher: hands need not face each other.
  double support = 0.03;
  double tear_thickness = 0.0;  ///< m, 0..0.02: a thinner wall tears (tearing.h). 0: never.
                                ///< Otherwise more than the clay's wall_min.
  double tear_strain = 0.0;     ///< 0..10: share by which a ring may get wider than the lump; more
                                ///< tears it. 0: never. Lower: bowls must be opened with care.
  /// sigma, Pa, 0..1e6: stress along one direction at which clay yields, as in a wall that bends
  /// under a hand. It is sqrt(3) times SlumpDef::yield_stress, which is in shear. Higher: thin
  /// walls feel harder. 0: walls do not bend.
  double bending_strength = 0.0;

  static constexpr const char* kName = "walls";
  static std::span<const DefField<WallsDef>> fields();
};

namespace effects {

/// True if `def` sets a limit at which walls tear.
inline bool tears(const WallsDef& def) { return def.tear_thickness > 0.0 || def.tear_strain > 0.0; }

/// How well a hand at `holding` supports the wall against a press at `pressing` on the other face:
/// 1 face to face, 0 beyond `def.support` along the wall. m, any frame about the axis.
double wall_support(const WallsDef& def, Vec3 pressing, Vec3 holding) noexcept;

/// The push at which a wall bends under a hand, N: the plastic collapse load of a clamped plate
/// under a point load, 4 pi times its plastic moment sigma t^2 / 4 (Save, Massonnet & de Saxce,
/// Plastic Limit Analysis of Plates, Shells and Disks, 1997). `strength`: the share of sigma that
/// water leaves. Grows with the square of the thickness. A free rim bears less; that is not
/// modelled.
double wall_bears(const WallsDef& def, double thickness, double strength) noexcept;

/// What a hand feels of a push of `normal` N on a wall that bends at `bears` (N; infinite for solid
/// clay), of which `held` (0..normal) rests on the other hand: held + W / sqrt(1 + (W / P)^2), with
/// W = normal - held and P = bears. Wall and clay yield in series: the wall gives at most P, and
/// nearly all of W far below it. Never steeper than `normal`, in either variable. N.
double wall_push(double normal, double bears, double held) noexcept;

/// The wall behind a hand: means over a patch about `at`, with weights that fall smoothly to 0 at
/// its edge, 8 mm away. So they have no steps, and neither have their slopes. Of rows and sectors
/// finer than 2 mm only some are looked at, always the same ones.
struct WallBehind {
  double thickness = 0, wetness = 0;  ///< m, 0..1. Solid rows have no wall, and are left out.
  /// How they change with `at`, up and round the ring, for each m; clay frame.
  Vec3 thicker, wetter;
};
/// `at`: clay frame, m; above the floor's top. `moisture`: null if the clay is dry. O(1).
WallBehind wall_behind(const Clay& clay, const Moisture* moisture, Vec3 at) noexcept;

/// Share of a push that the wall must bear itself, 0..1. It rises smoothly from 0 at the solid clay
/// to 1 at 8 mm above, where the foot no longer supports the wall.
struct ClearOfFoot {
  double share = 0, rise = 0;  ///< `rise`: for each m of height.
};
ClearOfFoot clear_of_foot(const Clay& clay, double height) noexcept;

/// A wall that bends stores less energy than clay that does not, by
///   D = integral over the depth of clear M - wall_push(clear M, P, 0),
/// with M the push at that depth. Here: how D grows with `clear` (0..1) and with P (`bears`, N) if
/// the depth stays. `alone`: the push without what the other hand holds, N. It is taken to have
/// grown as it does for a ball of `radius` (m) that is pressed `depth` (m) deep into an even face,
/// or, if `radius` is 0, for a tool's edge.
struct BendSlopes {
  double by_clear = 0;  ///< J.
  double by_bears = 0;  ///< m; 0 or less.
};
BendSlopes bend_slopes(double alone, double clear, double bears, double depth,
                       double radius) noexcept;

}  // namespace effects
}  // namespace onggi
