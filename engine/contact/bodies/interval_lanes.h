#pragma once

// Where eight rays of a row enter and leave slabs, rods and balls, the parts of which bodies are
// made. The point t of a ray is t (cos, 0, sin) + beside (-sin, 0, cos), at the row's height. For
// *_lanes.cpp only.

#include "engine/clay/wall_side.h"
#include "engine/contact/bodies/sections.h"
#include "engine/math/lanes.h"

namespace onggi::ONGGI_LANES {

using body::RodSection;
using body::SlabSection;

/// Where eight rays enter and leave, t in metres from the axis.
struct Interval {
  Float8 near, far;
};
/// An Interval, and the unit direction in which clay pushes the body at the worked end: against the
/// outer normal.
struct FacingInterval {
  Float8 near, far;
  Float8 x, y, z;
};

/// The figures of a cut for kernels, spread over eight lanes once per row.
struct SlabLanes {
  Float8 nx, ny, nz, half, off;

  ONGGI_INLINE explicit SlabLanes(const SlabSection& slab)
      : nx(all(slab.nx)),
        ny(all(slab.ny)),
        nz(all(slab.nz)),
        half(all(slab.half)),
        off(all(slab.off)) {}
};
struct RodLanes {
  Float8 radius, over_radius, mx, my, mz, ax, ay, az, ay_square, wx, wz, m_along;

  ONGGI_INLINE explicit RodLanes(const RodSection& rod)
      : radius(all(rod.radius)),
        over_radius(all(1.0f / rod.radius)),
        mx(all(rod.mx)),
        my(all(rod.my)),
        mz(all(rod.mz)),
        ax(all(rod.ax)),
        ay(all(rod.ay)),
        az(all(rod.az)),
        ay_square(all(rod.ay * rod.ay)),
        wx(all(rod.wx)),
        wz(all(rod.wz)),
        m_along(all(rod.m_along)) {}
};

ONGGI_INLINE Float8 off_zero(Float8 a) {
  const Float8 tiny = all(1e-7f);
  return select(abs(a) < tiny, tiny, a);
}

template <WallSide side>
ONGGI_INLINE Float8 worked_end(const Interval& in) {
  return side == WallSide::outside ? in.near : in.far;
}

template <WallSide side>
ONGGI_INLINE FacingInterval in_slab(const SlabLanes& slab, Float8 c, Float8 s, Float8 beside) {
  const Float8 slope = off_zero(slab.nx * c + slab.nz * s);
  const Float8 k = slab.off + beside * (slab.nz * c - slab.nx * s);
  const Float8 a = (all(0.0f) - slab.half - k) / slope;
  const Float8 b = (slab.half - k) / slope;
  // Turn the normal to point along the ray, or against it.
  const Float8 way = all(side == WallSide::outside ? 1.0f : -1.0f);
  const Float8 sign = select(slope < all(0.0f), all(0.0f) - way, way);
  return {smaller(a, b), larger(a, b), slab.nx * sign, slab.ny * sign, slab.nz * sign};
}

/// Uses the common perpendicular of ray and line, to avoid cancellation where the ray grazes the
/// rod. If the ray misses, far < near.
ONGGI_INLINE Interval in_rod(const RodLanes& rod, Float8 c, Float8 s, Float8 beside) {
  const Float8 along = rod.ax * c + rod.az * s;
  const Float8 aside = rod.az * c - rod.ax * s;
  const Float8 square = larger(rod.ay_square + aside * aside, all(1e-9f));
  const Float8 sine = sqrt(square);
  const Float8 apart = rod.wx * c + rod.wz * s + beside * rod.ay;
  const Float8 on_axis = rod.m_along + beside * aside;
  const Float8 middle = (rod.mx * c + rod.mz * s + on_axis * along) / square;
  const Float8 edge = rod.radius * sine;
  const Float8 chord = (edge - apart) * (edge + apart);
  const Float8 half = select(chord > all(0.0f), sqrt(larger(chord, all(0.0f))), all(-1.0f));
  return {middle - half / square, middle + half / square};
}
/// Distance along the rod's line from its point `middle` to the ray's point t.
ONGGI_INLINE Float8 along_rod(const RodLanes& rod, Float8 t, Float8 c, Float8 s, Float8 beside) {
  return rod.m_along + beside * (rod.az * c - rod.ax * s) + t * (rod.ax * c + rod.az * s);
}
/// From the ray's point t to the line's point at `q`, divided by the radius. If t lies on the rod,
/// this is the unit inner normal.
ONGGI_INLINE FacingInterval facing_rod(const RodLanes& rod, const Interval& in, Float8 t, Float8 q,
                                       Float8 c, Float8 s, Float8 beside) {
  const Float8 over = rod.over_radius;
  return {in.near, in.far, (rod.mx + q * rod.ax - (t * c - beside * s)) * over,
          (rod.my + q * rod.ay) * over, (rod.mz + q * rod.az - (t * s + beside * c)) * over};
}

/// A ball centred on (x, y, z), with y from the row's height. `section` is the radius of its circle
/// there. Empty if the ray misses.
ONGGI_INLINE Interval in_ball(Float8 section, Float8 x, Float8 z, Float8 c, Float8 s,
                              Float8 beside) {
  const Float8 off = z * c - x * s - beside;
  const Float8 chord = (section - off) * (section + off);
  const Float8 along = x * c + z * s;
  const Float8 half = sqrt(larger(chord, all(0.0f)));
  const Mask8 met = chord > all(0.0f);
  return {select(met, along - half, all(1e9f)), select(met, along + half, all(-1e9f))};
}

/// The intersection. The worked end is the deeper one.
template <WallSide side>
ONGGI_INLINE FacingInterval both(const FacingInterval& a, const FacingInterval& b) {
  const Mask8 second = side == WallSide::outside ? b.near > a.near : b.far < a.far;
  return {larger(a.near, b.near), smaller(a.far, b.far), select(second, b.x, a.x),
          select(second, b.y, a.y), select(second, b.z, a.z)};
}

}  // namespace onggi::ONGGI_LANES
