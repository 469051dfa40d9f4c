#pragma once

#include <array>

#include "engine/contact/bodies/ball.h"
#include "engine/contact/bodies/bounds.h"
#include "engine/contact/bodies/sections.h"

namespace onggi::body {

/// A block round `middle`: half lengths `half` along the unit directions `axis`, which are at right
/// angles. Clay frame, metres.
struct Box {
  Vec3 middle;
  std::array<Vec3, 3> axis;
  std::array<double, 3> half{};

  Heights heights() const noexcept;
  Hull hull() const noexcept;
  /// No bound: as potters hold it, it stands upright, and its rows are alike.
  Approach approach() const noexcept { return {}; }
  /// Bound of its section with the level plane at `y`: exact where no corner lies in the cut; else
  /// a little wide.
  Outline outline(double y) const noexcept;
  /// The ball of its farthest point `towards` (unit). If a face or an edge faces that way, of its
  /// middle. At most as large as the third half length or kBluntestEdge.
  Ball support(Vec3 towards) const noexcept;
  /// A ball in it, as thick as it is or as kBluntestEdge, that lies as far `towards` (unit) as such
  /// a ball can; where a face or an edge faces that way, in its middle.
  Ball within(Vec3 towards) const noexcept;

  /// The section itself: the intersection of three slabs.
  struct Section {
    SlabSection a, b, c;
  };
  Section section(double y) const noexcept;

  /// Upright: every level plane between its ends cuts it alike, except for slab `a`.
  bool upright() const noexcept {
    return axis[0].x == 0.0 && axis[0].z == 0.0 && axis[1].y == 0.0 && axis[2].y == 0.0;
  }
  /// section(y) of an upright box, derived from that of another of its planes.
  Section section_like(const Section& other, double y) const noexcept;
};

}  // namespace onggi::body
