#pragma once

#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/bodies/box.h"
#include "engine/contact/bodies/sections.h"

namespace onggi::body {

/// A disc centred on `middle`. It reaches `half` its thickness to either side along `axis` (unit).
/// Clay frame, metres.
class Cylinder {
 public:
  Cylinder(Vec3 middle, Vec3 axis, double radius, double half) noexcept;

  double radius() const noexcept { return box_.half[0]; }
  Vec3 axis() const noexcept { return box_.axis[2]; }
  Heights heights() const noexcept { return box_.heights(); }
  Hull hull() const noexcept { return box_.hull(); }
  Approach approach() const noexcept;
  /// Bound of the disc's section with the level plane at `y`; a little wide if the disc is tilted.
  Outline outline(double y) const noexcept;
  /// The ball at the farthest point `towards` (unit), or at the middle of a face that faces that
  /// way. Radius: at most the disc's radius and kBluntestEdge.
  Ball support(Vec3 towards) const noexcept;
  /// The ball inside the disc that lies farthest `towards` (unit), or at the middle of a face that
  /// faces that way. Radius: at most the disc's half thickness and kBluntestEdge.
  Ball within(Vec3 towards) const noexcept;

  /// The exact section: the intersection of a rod and a slab.
  struct Section {
    RodSection rod;
    SlabSection faces;
  };
  Section section(double y) const noexcept;

 private:
  Box box_;  // bounding box; axes: level, up its face, through it
};

}  // namespace onggi::body
