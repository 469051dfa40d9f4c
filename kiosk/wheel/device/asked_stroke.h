#pragma once

#include "kiosk/wheel/device/stroke_plan.h"

namespace onggi::device {

/// A stroke that a visitor chooses by button instead of drawing it: what the hands do,
enum class Ask : std::uint8_t {
  open,    ///< The hand inside makes the whole wall thinner and wider.
  widen,   ///< Both hands bring the wall outwards,
  narrow,  ///< or inwards.
  pull,    ///< They go up the wall and squeeze it.
  even,    ///< They go up it slowly and leave it where it is.
};
inline constexpr int kAsks = 5;

/// and where. Each part of the wall fades into its neighbours, so that no stroke leaves a ledge.
/// The weights of the five parts add up to 1 at every height.
enum class WallPart : std::uint8_t { foot, low, middle, high, rim, all };
inline constexpr int kWallParts = 6;
/// Height at which the part is strongest, as a share of the total; `all`: 0.5.
double middle_of(WallPart part);
/// Weight of `part`, 0..1, at `share` of the height.
double weight_of(WallPart part, double share);

/// The stroke for the current `clay`: at most 9 mm outwards or 4 mm inwards, and not beyond
/// `target`'s outline. If the whole part is already at the outline, at most 3 and 2 mm beyond it. A
/// wall too thick for two hands is opened first. The path is empty if nothing can be done. Pure;
/// allocates.
Stroke asked_stroke(const ClayView& clay, const Profile& target, Ask ask, WallPart part);

}  // namespace onggi::device
