#pragma once

namespace onggi::force {

/// What a decorating tool does to a leather-hard wall, as far as a hand feels it.
enum class DecoratingLaw { none, cut, scrape, brush, wipe, stamp };

/// A decorating tool in a hand. A figure outside its range counts as the nearer end, and one that
/// is not a number as the lower.
struct DecoratingTool {
  DecoratingLaw law = DecoratingLaw::none;
  double width = 1e-3;   ///< Of what touches, all teeth together, m, kLeastWidth..kMostWidth.
  double depth = 5e-4;   ///< That the tool is made for, m, kLeastDepth..kMostDepth; then it stops.
  double dryness = 0.0;  ///< Of the clay: 0 leather-hard .. 1 dry.
  double fill = 1.0;     ///< Share of width x depth that a cut takes, 0..1: 0.5 of a V.

  static constexpr double kLeastWidth = 2e-4, kMostWidth = 0.04;
  static constexpr double kLeastDepth = 1.5e-4, kMostDepth = 0.003;
  friend bool operator==(const DecoratingTool&, const DecoratingTool&) = default;
};

/// What a wall answers to a tool.
struct ToolPress {
  double push = 0.0;       ///< Out of the wall, N, >= 0.
  double grip = 0.0;       ///< The most that holds it along the wall, N, 0..kMostGrip.
  double stiffness = 0.0;  ///< Upper bound of d push / d depth, at any depth, N/m.
};
inline constexpr double kMostGrip = 8.0;

/// The answer at `depth` (m) in the wall; nothing at 0 and above it.
///
///   push = Y d / (d + d_y) + c min(d, D) + S max(0, d - D)
///   grip = min(most, k min(d, D) + mu push)
///
/// d the depth, D the tool's own. The first term is a blunt edge that sinks in, Y = 5.14 tau w e
/// (Prandtl 1920), a stiff spring that yields over d_y. k = tau w fill 2 cot(phi) is the cutting
/// resistance of an ideally plastic body by the plane of least work, phi = 45 deg - (beta - rake) /
/// 2 (Merchant 1945), and c = k tan(beta - rake) presses the tool off. tau = 170 kPa is the shear
/// strength of clay at its plastic limit (Wroth & Wood 1978), where it is leather-hard; dry it is
/// twice as much here, which is set from the ranges of forces that were asked for, as are brush,
/// finger and stamp (engine/docs/force.md). At S the tool is as deep as it
/// goes. Y / d_y and c are at most 500 N/m, as the wheel head, for which devices' couplings are
/// derived.
///
/// The push is a function of the depth alone, and rises with it: a spring, which gives nothing for
/// nothing. The grip is a limit of friction, for Coupling: it needs no velocity, and only takes.
/// Continuous in the depth. No allocation, no throw.
ToolPress press_of(const DecoratingTool& tool, double depth) noexcept;

}  // namespace onggi::force
