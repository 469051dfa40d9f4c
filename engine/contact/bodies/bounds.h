#pragma once

#include <array>

#include "engine/clay/wall_side.h"
#include "engine/math/vec.h"

namespace onggi::body {

/// A rod or a disc whose direction rises less than this is cut longer than any tool.
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

/// How near the axis a tool's sections come, told of each at less cost than its outline. Metres.
/// One that says nothing is at the axis.
struct Approach {
  double level = 0.0;  ///< The height of the section whose middle is `at`.
  Vec2 at;
  Vec2 lean;                      ///< How far that goes aside for a metre up.
  double round = 0.0;             ///< The section lies no farther from there,
  Vec2 through;                   ///< but for this to either side,
  Vec2 across;                    ///< and for the chord of a disc in this direction (unit):
  double radius = 0.0;            ///< of this radius,
  double half = 0.0, rise = 0.0;  ///< which loses so much of the height, and rises so steeply.

  /// Nothing of the section at height `y` is nearer to the axis; may be below 0.
  double nearest(double y) const noexcept;
};

/// What a tool's section with a level plane lies within: a parallelogram, its corners rounded off
/// outwards, and an oval where a round tool stands askew. Metres; floats, since rows are worked in
/// them.
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
  /// That holds the section; radius <= 0 where there is none.
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
/// from outside) or farther (from inside): `coarse`, or narrower where the outline is long and
/// thin. half < 0: nowhere.
Turn turn_of(const Outline& outline, WallSide side, double extent, const Turn& coarse) noexcept;
/// Angles that are in both, or one of the two where that would be two pieces.
Turn overlap(const Turn& a, const Turn& b) noexcept;

/// Puts an oval round `outline`: where the endless round rod of `radius` along `axis` (unit),
/// through `through`, is cut at height `y`. Nothing where it lies too level for that to help.
void add_oval(Outline& outline, Vec3 through, Vec3 axis, double radius, double y) noexcept;

}  // namespace onggi::body
