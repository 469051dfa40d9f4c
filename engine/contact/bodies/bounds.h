#pragma once

#include <array>

#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::body {

/// Smallest rise of a rod's or disc's direction for which its section is bounded. Below it the
/// section is longer than any tool.
inline constexpr double kAskew = 0.1;

/// The lowest and the highest point of a tool, m.
struct Heights {
  double low = 0.0, high = 0.0;
};

/// Angles about the axis, middle -+ half, rad. half < 0: empty; half >= pi: all round.
struct Turn {
  double middle = 0.0, half = 0.0;
};

/// Balls of equal radius. The tool lies within their convex hull.
struct Hull {
  std::array<Vec3, 8> middle;
  int count = 0;
  double radius = 0.0;
};

/// A circle in a level plane.
struct Circle {
  double x = 0.0, z = 0.0, radius = 0.0;
};

/// A lower bound on the distance of a tool's sections from the axis, cheaper than their outline.
/// Metres. The default, at the axis, excludes nothing.
struct Approach {
  double level = 0.0;  ///< Height of the section whose middle is `at`.
  Vec2 at;
  Vec2 lean;                      ///< Sideways shift of that middle per metre of height.
  double round = 0.0;             ///< The section lies within this radius of the middle,
  Vec2 through;                   ///< moved by up to this to either side,
  Vec2 across;                    ///< and along this (unit) by half a disc's chord:
  double radius = 0.0;            ///< the disc's radius,
  double half = 0.0, rise = 0.0;  ///< its half thickness as height, its steepness.

  /// Lower bound of the section's distance from the axis at height `y`; may be negative.
  double nearest(double y) const noexcept;
};

/// Bound of a tool's section with a level plane: a parallelogram with rounded corners, and an oval
/// if a round tool is tilted. Metres, as floats like the rows.
struct Outline {
  float x = 0, z = 0;            ///< Middle of the parallelogram.
  float ux = 0, uz = 0;          ///< From the middle to the middle of one side,
  float vx = 0, vz = 0;          ///< and to the middle of the next side.
  float round = 0;               ///< Added all round; negative if there is no section.
  float oval = 0;                ///< Half the oval's width; 0 if there is no oval.
  float oval_x = 0, oval_z = 0;  ///< Its middle.
  float oval_ax = 0,
        oval_az = 0;  ///< The oval's half length is sqrt(this^2 + half width^2), in this direction.

  bool operator==(const Outline&) const = default;
  /// A circle that contains the section; radius <= 0 if there is none.
  Circle circle() const noexcept;
};

/// The angles that a hull spans as seen from the axis. `at` is a point in the hull.
Turn turn_of(const Hull& hull, Vec3 at) noexcept;
/// Bounds of a hull's nearest and farthest distance from the axis, m. `at` is a point in the hull.
struct AxisReach {
  double nearest = 0.0, farthest = 0.0;
};
AxisReach reach_of(const Hull& hull, Vec3 at) noexcept;
/// The angles, seen from the axis, where the section lies nearer than `extent` (m; pressing from
/// outside) or farther (from inside). Returns `coarse`, or less if the outline is long and thin.
/// half < 0: nowhere.
Turn turn_of(const Outline& outline, WallSide side, double extent, const Turn& coarse) noexcept;
/// Angles in both. Returns one of the inputs if the overlap would be two pieces.
Turn overlap(const Turn& a, const Turn& b) noexcept;

/// Adds to `outline` the oval that height `y` cuts out of an endless round rod: `radius`, axis
/// along `axis` (unit) through the point `through`. Does nothing if the rod is too level for the
/// oval to help.
void add_oval(Outline& outline, Vec3 through, Vec3 axis, double radius, double y) noexcept;

}  // namespace onggi::body
