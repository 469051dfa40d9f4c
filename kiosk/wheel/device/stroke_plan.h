#pragma once

#include <optional>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/profile/profile.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::device {

/// One stroke of a potter's hands on a pot as it stands, as somebody would draw it on a screen.
struct Stroke {
  /// What it is for, as potters name it: a hand inside makes a thick wall thinner; both bring it
  /// outwards, or inwards; both only even it.
  enum class Kind : std::uint8_t { open, belly, collar, smooth };
  Kind kind = Kind::smooth;
  Grip grip = Grip::both;
  /// Where the worked face is to come, from the first to the last: x from the axis, y height, m.
  std::vector<Vec2> path;
  double speed = 0.02;  ///< m/s along it.
  /// Of the wall's thickness that both hands leave between them, 0.1..1; 1: all of it.
  double squeeze = 1.0;
};

/// The next stroke from `clay` towards `target`'s outer outline: from the foot to the rim where the
/// wall is off, no deeper than soft clay follows two hands without a ridge, and slower the nearer
/// it is. It widens by `widens` m at the most. Nothing once all that hands can reach is within
/// `near_enough` metres. Pure; allocates.
std::optional<Stroke> next_stroke(const ClayView& clay, const Profile& target, double near_enough,
                                  double widens = 0.009);

/// `target` as a ball of `radius`, m, rolled along its outside leaves it: where it bends inwards
/// more sharply, as at a neck, rounder. Inside as `target`. Pure; allocates.
Profile rolled(const Profile& target, double radius);

/// The hand inside makes a wall that is too thick for two hands thinner, from the floor to the rim,
/// by `widens` m at the most. Nothing where none is.
std::optional<Stroke> opening_stroke(const ClayView& clay, const Profile& target,
                                     double widens = 0.009);

/// The outer radius that `target` has where it answers `height` on the clay, m: clay that is kept
/// gets lower as it widens and comes to the target's height with its shape.
double wanted_radius(const ClayView& clay, const Profile& target, double height);

/// One slow stroke of both hands along all of `target` that is on `clay`.
Stroke last_stroke(const ClayView& clay, const Profile& target);

}  // namespace onggi::device
