#pragma once

#include <array>

#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::body {

/// A rod or disc whose direction rises less than this is cut longer than any tool.
inline constexpr double kAskew = 0.1;

/// The lowest and the highest point of a tool, m.
struct Heights {
  double low = 0.0, high = 0.0;
};

/// Angles about the axis, middle -+ half, rad; half < 0: none, half >= pi: all round.
struct Turn {
  double middle = 0.0, half = 0.0;
};

/// Balls of one radius; a tool lies within their hull.
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
/// Metres.
/// The default bound: at the axis, which says nothing.
struct Approach {
  double level = 0.0;  ///< The height of the section whose middle is `at`.
  Vec2 at;
  Vec2 lean;                      ///< How far that middle moves aside for a metre up.
  double round = 0.0;             ///< Radius round it that holds the section,
  Vec2 through;                   ///< apart from this to either side,
  Vec2 across;                    ///< and from a disc's chord in this direction (unit):
  double radius = 0.0;            ///< the disc's radius,
  double half = 0.0, rise = 0.0;  ///< its loss of height, and its steepness.

  /// No point of the section at height `y` is nearer to the axis; may be below 0.
  double nearest(double y) const noexcept;
};

/// Bound of a tool's section with a level plane: a parallelogram with corners rounded outwards, and
/// an oval where a round tool stands askew. Metres; floats, as for rows.
struct Outline {
  float x = 0, z = 0;              ///< Middle of the parallelogram.
  float ux = 0, uz = 0;            ///< From there to the middle of a side,
  float vx = 0, vz = 0;            ///< and of the next.
  float round = 0;                 ///< Added all round; negative where there is no section.
  float oval = 0;                  ///< Half the oval's width; 0 where there is no oval.
  float oval_x = 0, oval_z = 0;    ///< Its middle.
  float oval_ax = 0, oval_az = 0;  ///< Its half length is the root of this squared and its half
                                   ///< width squared, in this direction.

  bool operator==(const Outline&) const = default;
  /// A circle that holds the section; radius <= 0 if there is none.
  Circle circle() const noexcept;
};

/// The angles that a hull spans, seen from the axis; `at` is a point in it.
Turn turn_of(const Hull& hull, Vec3 at) noexcept;
/// Bounds of how near the axis a hull comes and how far from it, m; `at` is a point in it.
struct AxisReach {
  double nearest = 0.0, farthest = 0.0;
};
AxisReach reach_of(const Hull& hull, Vec3 at) noexcept;
/// The angles between which the section, seen from the axis, lies nearer than `extent` (m; pressing
/// from outside) or farther (from inside): `coarse`, or narrower if the outline is long and thin.
/// half < 0: nowhere.
Turn turn_of(const Outline& outline, WallSide side, double extent, const Turn& coarse) noexcept;
/// Angles that are in both. If that would be two pieces, one of the inputs.
Turn overlap(const Turn& a, const Turn& b) noexcept;

/// Adds an oval to `outline`: where the endless round rod of `radius` along `axis` (unit), through
/// `through`, is cut at height `y`. Does nothing if the rod lies too level for that to help.
void add_oval(Outline& outline, Vec3 through, Vec3 axis, double radius, double y) noexcept;

}  // namespace onggi::body
