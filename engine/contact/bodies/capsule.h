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
  /// Bound of the capsule's section with the level plane at `y`; a little wide if the capsule is
  /// tilted.
  Outline outline(double y) const noexcept;
  /// The ball at the farthest point `towards` (unit); at the capsule's middle if its side faces
  /// that way.
  Ball support(Vec3 towards) const noexcept;
  /// The ball inside that lies farthest `towards` (unit); at the capsule's middle if its side faces
  /// that way.
  Ball within(Vec3 towards) const noexcept;

  /// The exact section: two balls, and the rod between them.
  struct Section {
    RodSection rod;
    float length;
    float end_x, end_y, end_z;  ///< The far end, relative to the row's height.
  };
  Section section(double y) const noexcept;
};

}  // namespace onggi::body
