#pragma once

#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/bodies/sections.h"

namespace onggi::body {

/// All points within `radius` of a straight line from `tip`, `length` long. Clay frame, metres.
struct Capsule {
  Vec3 tip;
  Vec3 axis;  ///< Unit: from the tip to the other end.
  double length = 0, radius = 0;

  Vec3 end() const noexcept { return tip + length * axis; }
  Heights heights() const noexcept;
  Hull hull() const noexcept;
  Approach approach() const noexcept;
  /// Bound of its section with the level plane at `y`; a little wide if it lies askew.
  Outline outline(double y) const noexcept;
  /// The ball of its farthest point `towards` (unit); if its side faces that way, of its middle.
  Ball support(Vec3 towards) const noexcept;
  /// The ball in it that lies farthest `towards` (unit); where its side faces that way, in its
  /// middle.
  Ball within(Vec3 towards) const noexcept;

  /// The section itself: two balls, and the rod between.
  struct Section {
    RodSection rod;
    float length;
    float end_x, end_y, end_z;  ///< The far end, from the row's height.
  };
  Section section(double y) const noexcept;
};

}  // namespace onggi::body
