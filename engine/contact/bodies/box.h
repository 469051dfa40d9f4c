#pragma once

#include <array>

#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/bodies/sections.h"

namespace onggi::body {

/// A block centred on `middle`. `half` are half lengths along the unit directions `axis`, which are
/// at right angles. Clay frame, metres.
struct Box {
  Vec3 middle;
  std::array<Vec3, 3> axis;
  std::array<double, 3> half{};

  Heights heights() const noexcept;
  Hull hull() const noexcept;
  /// No bound: potters hold a rib upright, and an upright rib's rows are alike.
  Approach approach() const noexcept { return {}; }
  /// Bound of the box's section with the level plane at `y`. Exact if the cut contains no corner;
  /// else a little wide.
  Outline outline(double y) const noexcept;
  /// The ball at the farthest point `towards` (unit), or at the middle of the face or edge that
  /// faces that way. Radius: at most the third half length and kBluntestEdge.
  Ball support(Vec3 towards) const noexcept;
  /// The ball inside the box that lies farthest `towards` (unit), or at the middle of the face or
  /// edge that faces that way. Radius: at most the box's half thickness and kBluntestEdge.
  Ball within(Vec3 towards) const noexcept;

  /// The exact section: the intersection of three slabs.
  struct Section {
    SlabSection a, b, c;
  };
  Section section(double y) const noexcept;

  /// Upright: every level plane between the ends gives the same cut, except for slab `a`.
  bool upright() const noexcept {
    return axis[0].x == 0.0 && axis[0].z == 0.0 && axis[1].y == 0.0 && axis[2].y == 0.0;
  }
  /// section(y) of an upright box, derived from `other`, its section at another height.
  Section section_like(const Section& other, double y) const noexcept;
};

}  // namespace onggi::body
