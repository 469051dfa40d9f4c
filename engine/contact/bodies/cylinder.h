#pragma once

#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/bodies/box.h"
#include "engine/contact/bodies/sections.h"

namespace onggi::body {

/// A disc round `middle`: `radius`, and `half` its thickness to either side along `axis` (unit).
/// Clay frame, metres.
class Cylinder {
 public:
  Cylinder(Vec3 middle, Vec3 axis, double radius, double half) noexcept;

  double radius() const noexcept { return box_.half[0]; }
  Vec3 axis() const noexcept { return box_.axis[2]; }
  Heights heights() const noexcept { return box_.heights(); }
  Hull hull() const noexcept { return box_.hull(); }
  Approach approach() const noexcept;
  /// Bound of its section with the level plane at `y`; a little wide if it stands askew.
  Outline outline(double y) const noexcept;
  /// The ball of its farthest point `towards` (unit); if a face faces that way, of its middle. At
  /// most as large as its radius or kBluntestEdge.
  Ball support(Vec3 towards) const noexcept;
  /// A ball in it, as thick as it is or as kBluntestEdge, that lies as far `towards` (unit) as such
  /// a ball can; where a face faces that way, in its middle.
  Ball within(Vec3 towards) const noexcept;

  /// The section itself: the intersection of a rod and a slab.
  struct Section {
    RodSection rod;
    SlabSection faces;
  };
  Section section(double y) const noexcept;

 private:
  Box box_;  // round it: level, up its face, through it
};

}  // namespace onggi::body
