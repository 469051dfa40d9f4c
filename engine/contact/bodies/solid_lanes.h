#pragma once

// How a body other than a ball meets a row: how much of each element it covers, where it ends on
// the elements' rays, and which way its surface faces there. The body's file gives the interval of
// its section on a ray:
//
//   struct Shape {
//     using Body = ...;
//     explicit Shape(const Body::Section&);  // once a row
//     template <WallSide side> FacingInterval interval(Float8 cos, Float8 sin, Float8 beside)
//     const;
//     static constexpr bool kLeans = ...;  // what it feels is right also where it leans on a wall
//     bool leans() const;                  // with kLeans, as is over_radius()
//     Float8 over_radius() const;
//   };
//
// and instantiates Kernel<SolidLaw<Shape>>. For *_lanes.cpp only.

#include "engine/contact/bodies/interval_lanes.h"
#include "engine/contact/press_lanes.h"

namespace onggi::ONGGI_LANES {

/// A Meeting (press_lanes.h) that says which way the body is pushed.
struct FacingMeeting {
  Float8 end, covered;
  Mask8 hit;
  Float8 left, right;
  Float8 x, y, z;
};

// An element is a strip as wide as its sector. Only the part that the section covers gives way and
// is felt. The body's end is taken in the middle of that part. So a body narrower than an element
// still finds the element, and the force does not step as elements come and go. Coverage uses the
// sector's width at the body's edge, because the edge sets how fast coverage changes. The width at
// the face would be too large for a disc deep in clay, whose edge is centimetres nearer the axis.
template <class Shape>
struct SolidLaw {
  using Body = typename Shape::Body;
  static constexpr bool kPlain = false;
  static constexpr bool kEdges = true;

  struct Row {
    using Met = FacingMeeting;
    Shape shape;
    const body::Outline& outline;
    Float8 x, z, ux, uz, vx, vz, round;  // of the outline
    Float8 sector, share;

    ONGGI_INLINE Row(const BodyFigures<Body>&, const BodyRow<Body>& row)
        : shape(row.section),
          outline(*row.outline),
          x(all(outline.x)),
          z(all(outline.z)),
          ux(all(outline.ux)),
          uz(all(outline.uz)),
          vx(all(outline.vx)),
          vz(all(outline.vz)),
          round(all(outline.round)),
          sector(all(row.sector)),
          share(all(row.share)) {}

    // In elements from the ray.
    struct Strip {
      Float8 low, high;
    };
    // The place of an outline's corner beside a ray, in elements. From outside, a corner within the
    // clay uses its own distance from the axis, which sets how fast it passes. Other corners use
    // the face's.
    template <WallSide side>
    ONGGI_INLINE Float8 in_elements(Float8 beside, Float8 along, Float8 face) const {
      Float8 from = face;
      if constexpr (side == WallSide::outside)
        from = smaller(larger(along, all(0.5f) * face), face);
      return beside / (larger(from, all(1e-6f)) * sector);
    }
    // The outline beside a ray, m. `ahead`: half of the distance along the ray between its corners,
    // about `along`.
    struct Beside {
      Float8 low, high, u, v;
    };
    ONGGI_INLINE Beside beside_of(Float8 c, Float8 s) const {
      const Float8 off = z * c - x * s;
      const Float8 u = uz * c - ux * s;
      const Float8 v = vz * c - vx * s;
      const Float8 half = abs(u) + abs(v) + round;
      return {off - half, off + half, u, v};
    }
    template <WallSide side>
    ONGGI_INLINE Strip covered_strip(Float8 c, Float8 s, Float8 face, const Beside& at) const {
      const body::Outline& o = outline;
      const Float8 zero = all(0.0f);
      const Float8 along = x * c + z * s;
      const Float8 ahead_u = ux * c + uz * s;
      const Float8 ahead_v = vx * c + vz * s;
      const Float8 ahead = select(at.u < zero, zero - ahead_u, ahead_u) +
                           select(at.v < zero, zero - ahead_v, ahead_v);
      const Float8 edge = all(0.5f);
      Strip strip{larger(in_elements<side>(at.low, along - ahead, face), zero - edge),
                  smaller(in_elements<side>(at.high, along + ahead, face), edge)};
      if (o.oval > 0.0f) {
        const Float8 middle = all(o.oval_z) * c - all(o.oval_x) * s;
        const Float8 longer = all(o.oval_az) * c - all(o.oval_ax) * s;
        const Float8 reach = sqrt(all(o.oval * o.oval) + longer * longer);
        strip.low = larger(strip.low, in_elements<side>(middle - reach, face, face));
        strip.high = smaller(strip.high, in_elements<side>(middle + reach, face, face));
      }
      return strip;
    }
    template <WallSide side, bool>
    ONGGI_INLINE void meet(Float8 c, Float8 s, Float8 face, FacingMeeting& m) const {
      const Float8 zero = all(0.0f);
      const Float8 width = larger(face, all(1e-6f)) * sector;
      const Float8 edge = all(0.5f) * width;
      const Beside at = beside_of(c, s);
      Strip strip{all(-0.5f), all(0.5f)};
      // Elements are widest at the face: what the outline reaches across there is covered.
      if (outline.oval > 0.0f || !none((at.low > zero - edge) | (at.high < edge)))
        strip = covered_strip<side>(c, s, face, at);
      const Float8 part = strip.high - strip.low;
      const FacingInterval in =
          shape.template interval<side>(c, s, all(0.5f) * (strip.low + strip.high) * width);
      Mask8 hit = (part > zero) & (in.far > in.near);
      // An outside body works the half of the clay that it stands over.
      if constexpr (side == WallSide::outside) hit = hit & (in.near + in.far > zero);
      m.end = side == WallSide::outside ? in.near : in.far;
      m.hit = hit;
      m.covered = smaller(part, all(1.0f)) * share;
      m.left = (strip.low + all(0.5f)) * share;
      m.right = (all(0.5f) - strip.high) * share;
      m.x = in.x;
      m.y = in.y;
      m.z = in.z;
    }
    // A body that leans on the wall (Shape::kLeans) feels the pressure of the edge's law on its own
    // surface (crown.h): an element's share of that surface is larger by 1 over how squarely it
    // faces the ray. Without this the sum would push the body along an even wall. The sum of normal
    // forces stays that of the elements.
    ONGGI_INLINE void react(RowSum& sum, Float8 weight, Float8 press, const FacingMeeting& m,
                            Float8 c, Float8 s) const {
      Float8 felt = weight;
      if constexpr (Shape::kLeans)
        if (shape.leans()) {
          const Float8 deep = smaller(press * shape.over_radius(), all(1.0f));
          const Float8 bent = all(1.0f) - deep * (all(0.5f) - all(0.21828f) * deep);
          const Float8 facing = abs(m.x * c + m.z * s);
          felt = weight * bent / larger(facing, all(contact::kLeastFacing));
        }
      sum.weight = sum.weight + weight;
      sum.x = sum.x + felt * m.x;
      sum.y = sum.y + felt * m.y;
      sum.z = sum.z + felt * m.z;
    }
  };

  ONGGI_INLINE static void collect(const BodyFigures<Body>&, const RowSum& sum, float area,
                                   Reaction& total) {
    const Float8 share_of = all(area);
    total.normal = total.normal + sum.weight * share_of;
    total.x = total.x + sum.x * share_of;
    total.y = total.y + sum.y * share_of;
    total.z = total.z + sum.z * share_of;
  }
};

}  // namespace onggi::ONGGI_LANES
