#pragma once

#include "kiosk/wheel/device/stroke_plan.h"

namespace onggi::device {

/// A stroke as somebody asks for it who does not draw it: what the hands do,
enum class Ask : std::uint8_t {
  open,    ///< The hand inside makes the whole wall thinner and wider.
  widen,   ///< Both hands bring the wall outwards,
  narrow,  ///< or inwards.
  pull,    ///< They go up the wall and squeeze it.
  even,    ///< They go up it slowly and leave it where it is.
};
inline constexpr int kAsks = 5;

/// and where. Each part of the wall fades into its neighbours, so that no stroke leaves a ledge;
/// the weights of the five parts add up to 1 at every height.
enum class WallPart : std::uint8_t { foot, low, middle, high, rim, all };
inline constexpr int kWallParts = 6;
/// Where the part is strongest, as a share of the height; `all`: 0.5.
double middle_of(WallPart part);
/// 0..1 of `part` at `share` of the height.
double weight_of(WallPart part, double share);

/// The stroke on `clay` as it stands: 9 mm outwards or 4 mm inwards at the most, and no farther
/// than to where `target` runs, until all of the part is there: from then on 3 and 2 mm. A wall too
/// thick for two hands to bring outwards is opened first. No path where there is nothing to be gone
/// along. Pure; allocates.
Stroke asked_stroke(const ClayView& clay, const Profile& target, Ask ask, WallPart part);

}  // namespace onggi::device
