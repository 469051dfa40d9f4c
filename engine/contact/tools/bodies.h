// The bodies that tools are made of: a capsule, a block and a disc, each with its exact span on a
// ray (solid_rows.h). Compiled once for each kind of vector: include it only from such a file.
#if defined(ONGGI_CONTACT_TOOLS_BODIES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_TOOLS_BODIES_H
#undef ONGGI_CONTACT_TOOLS_BODIES_H
#else
#define ONGGI_CONTACT_TOOLS_BODIES_H
#endif

#include "engine/contact/solid_rows.h"
#include "engine/contact/tool_balls.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {  // each tool has the kernel to itself, and the compiler can see all of it

// A ray of a row stands at t (cos, 0, sin) + beside (-sin, 0, cos), at the row's height.

HWY_INLINE Float8 off_zero(Float8 a) {
  const Float8 tiny = all(1e-7f);
  return select(abs(a) < tiny, tiny, a);
}

/// Between two planes.
struct SlabCut {
  float nx, ny, nz;  // unit normal
  float half;        // half the distance between the planes, m
  float off;         // of the row's middle on the axis from the middle plane, along the normal, m

  SlabCut(Vec3 middle, Vec3 normal, double half_width, double y)
      : nx(static_cast<float>(normal.x)),
        ny(static_cast<float>(normal.y)),
        nz(static_cast<float>(normal.z)),
        half(static_cast<float>(half_width)),
        off(static_cast<float>(normal.y * (y - middle.y) - normal.x * middle.x -
                               normal.z * middle.z)) {}

  template <WallSide side>
  HWY_INLINE Span span(Float8 c, Float8 s, Float8 beside) const {
    const Float8 slope = off_zero(all(nx) * c + all(nz) * s);
    const Float8 k = all(off) + beside * (all(nz) * c - all(nx) * s);
    const Float8 a = (all(0.0f) - all(half) - k) / slope;
    const Float8 b = (all(half) - k) / slope;
    // The normal that points along the ray, or against it.
    const Float8 way = all(side == WallSide::outside ? 1.0f : -1.0f);
    const Float8 sign = select(slope < all(0.0f), all(0.0f) - way, way);
    return {smaller(a, b), larger(a, b), all(nx) * sign, all(ny) * sign, all(nz) * sign};
  }
};

/// Within `radius` of a straight line through `middle`.
struct RodCut {
  float radius;
  float mx, my, mz;  // middle, from the row's height
  float ax, ay, az;  // unit direction
  float wx, wz;      // of direction x (axis at this height - middle)
  float m_along;     // (axis at this height - middle) . direction

  RodCut(Vec3 middle, Vec3 axis, double r, double y)
      : radius(static_cast<float>(r)),
        mx(static_cast<float>(middle.x)),
        my(static_cast<float>(middle.y - y)),
        mz(static_cast<float>(middle.z)),
        ax(static_cast<float>(axis.x)),
        ay(static_cast<float>(axis.y)),
        az(static_cast<float>(axis.z)) {
    const Vec3 from{-middle.x, y - middle.y, -middle.z};
    const Vec3 w = cross(axis, from);
    wx = static_cast<float>(w.x);
    wz = static_cast<float>(w.z);
    m_along = static_cast<float>(dot(from, axis));
  }

  struct Ends {
    Float8 near, far;
  };
  // By the common perpendicular of ray and line: nothing cancels where the ray grazes the rod.
  HWY_INLINE Ends ends(Float8 c, Float8 s, Float8 beside) const {
    const Float8 along = all(ax) * c + all(az) * s;
    const Float8 aside = all(az) * c - all(ax) * s;
    const Float8 square = larger(all(ay * ay) + aside * aside, all(1e-9f));
    const Float8 sine = sqrt(square);
    const Float8 apart = all(wx) * c + all(wz) * s + beside * all(ay);
    const Float8 on_axis = all(m_along) + beside * aside;
    const Float8 middle = (all(mx) * c + all(mz) * s + on_axis * along) / square;
    const Float8 edge = all(radius) * sine;
    const Float8 chord = (edge - apart) * (edge + apart);
    // Where the ray misses, far is before near.
    const Float8 half = select(chord > all(0.0f), sqrt(larger(chord, all(0.0f))), all(-1.0f));
    return {middle - half / square, middle + half / square};
  }
  /// How far along the line the ray's point t is, from `middle`.
  HWY_INLINE Float8 along_at(Float8 t, Float8 c, Float8 s, Float8 beside) const {
    return all(m_along) + beside * (all(az) * c - all(ax) * s) + t * (all(ax) * c + all(az) * s);
  }
  /// From the ray's point t to the line's point `q` along, over the radius: where t is on the rod,
  /// unit, and against its outer normal.
  HWY_INLINE Span inward(Ends e, Float8 t, Float8 q, Float8 c, Float8 s, Float8 beside) const {
    const Float8 over = all(1.0f / radius);
    return {e.near, e.far, (all(mx) + q * all(ax) - (t * c - beside * s)) * over,
            (all(my) + q * all(ay)) * over, (all(mz) + q * all(az) - (t * s + beside * c)) * over};
  }
};

template <WallSide side>
HWY_INLINE Float8 worked_end(Float8 near, Float8 far) {
  return side == WallSide::outside ? near : far;
}

/// What is in both; the end that is worked is the one that lies deeper in.
template <WallSide side>
HWY_INLINE Span both(const Span& a, const Span& b) {
  const Mask8 second = side == WallSide::outside ? b.near > a.near : b.far < a.far;
  return {larger(a.near, b.near), smaller(a.far, b.far), select(second, b.x, a.x),
          select(second, b.y, a.y), select(second, b.z, a.z)};
}

/// All points within `radius` of a straight line from the tip, size.length long.
struct Capsule {
  Vec3 tip, axis;
  double length, radius;

  Capsule(const ToolPlace& place, const ToolSize& size)
      : tip(place.at), axis(place.along), length(size.length), radius(size.radius) {}

  Vec3 end() const { return tip + length * axis; }
  Heights heights() const {
    return {std::min(tip.y, end().y) - radius, std::max(tip.y, end().y) + radius};
  }
  Hull hull() const {
    Hull hull;
    hull.middle[0] = tip;
    hull.middle[1] = end();
    hull.count = 2;
    hull.radius = radius;
    return hull;
  }
  Outline outline(double y) const {
    // The part of its line that comes within the radius of the plane.
    double from = 0.0;
    double to = length;
    double nearest = 0.0;
    if (std::fabs(axis.y) > 1e-9) {
      const double a = (y - radius - tip.y) / axis.y;
      const double b = (y + radius - tip.y) / axis.y;
      from = std::clamp(std::min(a, b), 0.0, length);
      to = std::clamp(std::max(a, b), 0.0, length);
      nearest = std::clamp((y - tip.y) / axis.y, 0.0, length);
    }
    const double round = cross_section(radius, tip.y + nearest * axis.y - y);
    const Vec3 middle = tip + 0.5 * (from + to) * axis;
    const Vec3 half = 0.5 * (to - from) * axis;
    Outline out;
    out.x = static_cast<float>(middle.x);
    out.z = static_cast<float>(middle.z);
    out.ux = static_cast<float>(half.x);
    out.uz = static_cast<float>(half.z);
    out.round = static_cast<float>(round);
    if (to > from) add_oval(out, tip, axis, radius, y);
    return out;
  }

  struct Cut {
    RodCut rod;
    float length;
    float end_x, end_y, end_z;  // the far end's middle, from the row's height

    // A ball round (x, y, z) on the ray: near and far, empty where it is missed.
    HWY_INLINE RodCut::Ends ball(float x, float y, float z, Float8 c, Float8 s,
                                 Float8 beside) const {
      const Float8 off = all(z) * c - all(x) * s - beside;
      const float square = (rod.radius - y) * (rod.radius + y);
      const Float8 section = all(square > 0.0f ? std::sqrt(square) : 0.0f);
      const Float8 chord = (section - off) * (section + off);
      const Float8 along = all(x) * c + all(z) * s;
      const Float8 half = sqrt(larger(chord, all(0.0f)));
      const Mask8 met = chord > all(0.0f);
      return {select(met, along - half, all(1e9f)), select(met, along + half, all(-1e9f))};
    }
    template <WallSide side>
    HWY_INLINE Span span(Float8 c, Float8 s, Float8 beside) const {
      const RodCut::Ends a = ball(rod.mx, rod.my, rod.mz, c, s, beside);
      const RodCut::Ends b = ball(end_x, end_y, end_z, c, s, beside);
      // The rod between the two balls.
      const RodCut::Ends rest = rod.ends(c, s, beside);
      const Float8 slope = off_zero(all(rod.ax) * c + all(rod.az) * s);
      const Float8 begin = all(rod.m_along) + beside * (all(rod.az) * c - all(rod.ax) * s);
      const Float8 p = (all(0.0f) - begin) / slope;
      const Float8 q = (all(length) - begin) / slope;
      const Float8 near = larger(rest.near, smaller(p, q));
      const Float8 far = smaller(rest.far, larger(p, q));
      const Mask8 met = near < far;
      RodCut::Ends whole{smaller(a.near, b.near), larger(a.far, b.far)};
      whole.near = smaller(whole.near, select(met, near, all(1e9f)));
      whole.far = larger(whole.far, select(met, far, all(-1e9f)));
      const Float8 t = worked_end<side>(whole.near, whole.far);
      const Float8 on = larger(smaller(rod.along_at(t, c, s, beside), all(length)), all(0.0f));
      return rod.inward(whole, t, on, c, s, beside);
    }
  };
  Cut cut(double y) const {
    const Vec3 far = end();
    return {RodCut(tip, axis, radius, y), static_cast<float>(length), static_cast<float>(far.x),
            static_cast<float>(far.y - y), static_cast<float>(far.z)};
  }
};

/// A block round `at`: size.length along, size.thickness across, and 2 size.radius wide.
struct Plate {
  Block block;

  Plate(const ToolPlace& place, const ToolSize& size) : block(plate_block(place, size)) {}
  Heights heights() const { return block.heights(); }
  Hull hull() const { return block.hull(); }
  Outline outline(double y) const { return block.outline(y); }

  struct Cut {
    SlabCut a, b, c;
    template <WallSide side>
    HWY_INLINE Span span(Float8 cos, Float8 sin, Float8 beside) const {
      return both<side>(both<side>(a.template span<side>(cos, sin, beside),
                                   b.template span<side>(cos, sin, beside)),
                        c.template span<side>(cos, sin, beside));
    }
  };
  Cut cut(double y) const {
    const auto slab = [&](std::size_t k) {
      return SlabCut(block.middle, block.axis[k], block.half[k], y);
    };
    return {slab(0), slab(1), slab(2)};
  }
};

/// A disc round `at`: size.radius, and size.thickness across.
struct Disc {
  Block block;  // round it: level, up its face, across

  Disc(const ToolPlace& place, const ToolSize& size) : block(disc_block(place, size)) {}

  double radius() const { return block.half[0]; }
  Vec3 axis() const { return block.axis[2]; }
  Heights heights() const { return block.heights(); }
  Hull hull() const { return block.hull(); }
  Outline outline(double y) const {
    // How far up its face the plane can cut it at least; there its level chord is longest.
    const double rise = block.axis[1].y;
    const double up = std::fabs(y - block.middle.y) - block.half[2] * std::fabs(axis().y);
    Block narrow = block;
    if (rise > 0.1) {
      const double chord = cross_section(radius(), std::max(up / rise, 0.0));
      if (chord <= 0.0) {
        Outline none;
        none.round = -1.0f;
        return none;
      }
      narrow.half[0] = chord;
    }
    Outline out = narrow.outline(y);
    if (out.round >= 0.0f) add_oval(out, block.middle, axis(), radius(), y);
    return out;
  }

  struct Cut {
    RodCut rod;
    SlabCut faces;
    template <WallSide side>
    HWY_INLINE Span span(Float8 c, Float8 s, Float8 beside) const {
      const RodCut::Ends e = rod.ends(c, s, beside);
      const Float8 t = worked_end<side>(e.near, e.far);
      const Span round = rod.inward(e, t, rod.along_at(t, c, s, beside), c, s, beside);
      return both<side>(round, faces.template span<side>(c, s, beside));
    }
  };
  Cut cut(double y) const {
    return {RodCut(block.middle, axis(), radius(), y),
            SlabCut(block.middle, axis(), block.half[2], y)};
  }
};

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
