#pragma once

#include <optional>
#include <vector>

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/profile/profile.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::device {

/// One stroke of a potter's hands on the current pot, as a visitor would draw it on a screen.
struct Stroke {
  /// Its purpose, in potters' words: a hand inside thins a thick wall; both hands move the wall
  /// outwards or inwards; both only even it.
  enum class Kind : std::uint8_t { open, belly, collar, smooth };
  Kind kind = Kind::smooth;
  Grip grip = Grip::both;
  /// Path of the worked face: x from the axis, y height, m.
  std::vector<Vec2> path;
  double speed = 0.02;  ///< m/s along it.
  /// Share of the wall's thickness that both hands leave between them, 0.1..1; 1: all of it.
  double squeeze = 1.0;
};

/// The next stroke from `clay` towards `target`'s outer outline, from the foot to the rim where the
/// wall is off. It goes no deeper than soft clay can follow two hands without a ridge, and slows
/// down near the target. It widens by at most `widens` m. Nothing once everything within the hands'
/// reach is within `near_enough` metres. Pure; allocates.
std::optional<Stroke> next_stroke(const ClayView& clay, const Profile& target, double near_enough,
                                  double widens = 0.009);

/// `target` after a ball of `radius`, m, has rolled along its outside: sharper inward bends, such
/// as a neck, become rounder. The inside is `target`'s. Pure; allocates.
Profile rolled(const Profile& target, double radius);

/// A stroke in which the inside hand thins a wall that is too thick for two hands, from the floor
/// to the rim, by at most `widens` m. Nothing if no wall is too thick.
std::optional<Stroke> opening_stroke(const ClayView& clay, const Profile& target,
                                     double widens = 0.009);

/// The outer radius of `target` that corresponds to `height` on the clay, m. Clay that keeps its
/// volume gets lower as it widens, and reaches the target's height together with its shape.
double wanted_radius(const ClayView& clay, const Profile& target, double height);

/// One slow stroke of both hands along the whole `target` on `clay`.
Stroke last_stroke(const ClayView& clay, const Profile& target);

}  // namespace onggi::device
