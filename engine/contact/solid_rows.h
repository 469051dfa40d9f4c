// How a tool that is no ball meets the clay's rows: which elements it can reach, how much of each
// it covers, where it ends on their rays and which way its surface faces there. A tool's file gives
// a Body (engine/contact/tools/bodies.h has three):
//
//   struct Body {
//     Body(const ToolPlace&, const ToolSize&);
//     Heights heights() const;         // it lies between them
//     Hull hull() const;               // and within these
//     Outline outline(double y) const; // round its section with the level plane at y
//     Cut cut(double y) const;         // that section, exactly
//   };
//   struct Cut {
//     template <WallSide side> Span span(Float8 cos, Float8 sin, Float8 beside) const;
//   };
//
// and presses with Solid<Body>. Compiled once for each kind of vector: include it only from such a
// file.
#if defined(ONGGI_CONTACT_SOLID_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_SOLID_ROWS_H
#undef ONGGI_CONTACT_SOLID_ROWS_H
#else
#define ONGGI_CONTACT_SOLID_ROWS_H
#endif

#include <algorithm>
#include <cmath>

#include "engine/contact/outline.h"
#include "engine/contact/press_rows.h"
#include "engine/math/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {

/// Where eight rays enter and leave a section, and the unit direction in which clay pushes the tool
/// at the end that is worked: against its surface's outer normal.
struct Span {
  Float8 near, far;
  Float8 x, y, z;
};

/// A Meeting (press_rows.h) that says which way the tool is pushed.
struct Facing {
  Float8 end, covered;
  Mask8 hit;
  Float8 x, y, z;
};

/// What a solid tool may touch of one row: beside RowReach, where in the row's height it is looked
/// at, how much of that height it covers (0..1), and the section's outline there.
struct SolidReach : RowReach {
  double y = 0.0;
  float share = 0.0f;
  float sector = 0.0f;  ///< Angle of an element, rad.
  Outline outline;
};

// An element is a strip as wide as its sector is at its face. The strip's part that the
// section covers gives way and is felt, and where the tool ends is asked in the middle of that
// part: a tool narrower than an element still finds the element, and no force steps as elements
// come and go at its edges.
template <class Cut>
struct SolidRow {
  Cut cut;
  Outline outline;
  float sector, share;  // rad; of the row's height that is covered

  struct Strip {
    Float8 low, high;
  };
  HWY_INLINE Strip covered_strip(Float8 c, Float8 s, Float8 width) const {
    const Outline& o = outline;
    const Float8 off = all(o.z) * c - all(o.x) * s;
    const Float8 half =
        abs(all(o.uz) * c - all(o.ux) * s) + abs(all(o.vz) * c - all(o.vx) * s) + all(o.round);
    const Float8 edge = all(0.5f) * width;
    Strip strip{larger(off - half, all(0.0f) - edge), smaller(off + half, edge)};
    if (o.oval > 0.0f) {
      const Float8 middle = all(o.oval_z) * c - all(o.oval_x) * s;
      const Float8 longer = all(o.oval_az) * c - all(o.oval_ax) * s;
      const Float8 reach = sqrt(all(o.oval * o.oval) + longer * longer);
      strip.low = larger(strip.low, middle - reach);
      strip.high = smaller(strip.high, middle + reach);
    }
    return strip;
  }
  template <WallSide side, bool careful>
  HWY_INLINE Facing meet(Float8 c, Float8 s, Float8 face) const {
    const Float8 width = larger(face, all(1e-6f)) * all(sector);
    const Strip strip = covered_strip(c, s, width);
    const Float8 part = (strip.high - strip.low) / width;
    const Span span = cut.template span<side>(c, s, all(0.5f) * (strip.low + strip.high));
    Mask8 hit = (strip.high > strip.low) & (span.far > span.near);
    // A tool outside works the half of the clay that it stands over.
    if constexpr (side == WallSide::outside) hit = hit & (span.near + span.far > all(0.0f));
    return {side == WallSide::outside ? span.near : span.far,
            smaller(part, all(1.0f)) * all(share),
            hit,
            span.x,
            span.y,
            span.z};
  }
  HWY_INLINE void react(RowSum& sum, Float8 weight, const Facing& m, Float8, Float8) const {
    sum.weight = sum.weight + weight;
    sum.x = sum.x + weight * m.x;
    sum.y = sum.y + weight * m.y;
    sum.z = sum.z + weight * m.z;
  }
};

/// Which rows a solid tool reaches, and between which angles.
struct SolidWindow {
  int first_row = 0, end_row = 0;
  Turn turn;
  double nearest = 0.0, farthest = 0.0;  // m: nothing of the tool is nearer to the axis, or farther
};

/// A Shape (press_rows.h) made of a Body.
template <class Body>
struct Solid {
  using Reach = SolidReach;

  Body body;
  Heights heights;

  Solid(const ToolPlace& place, const ToolSize& size)
      : body(place, size), heights(body.heights()) {}

  SolidWindow window(const Clay& clay, Vec3 at) const {
    const Hull hull = body.hull();
    const auto [nearest, farthest] = reach_of(hull, at);
    // Along the ray of an element that the tool meets at its edge, it is a little nearer.
    const double half_sector = portable::kPi / clay.sectors();
    // Rows whose middles it misses may still be covered in part.
    return {std::max(clay.first_row_above(heights.low) - 1, 0),
            std::min(clay.first_row_above(heights.high) + 1, clay.rows()), turn_of(hull, at),
            nearest * (1.0 - 0.5 * half_sector * half_sector), farthest};
  }

  template <WallSide side>
  void plan(const Clay& clay, const SolidWindow& window, int first, int count,
            SolidReach* rows) const {
    for (int n = 0; n < count; n += kLanes)
      plan_few<side>(clay, window, first + n, std::min(count - n, kLanes), rows + n);
  }

  // At most kLanes.
  template <WallSide side>
  void plan_few(const Clay& clay, const SolidWindow& window, int first, int count,
                SolidReach* rows) const {
    float distance[kLanes] = {};
    float radius[kLanes] = {};
    float tangent[kLanes] = {};
    float extent[kLanes] = {};
    double angle[kLanes] = {};
    Circle last;
    double last_angle = 0.0;
    for (int k = 0; k < count; ++k) {
      const int j = first + k;
      SolidReach& row = rows[k];
      row.used = 0;
      const double half = 0.5 * clay.row_thickness(j);
      const double low = std::max(clay.row_height(j) - half, heights.low);
      const double high = std::min(clay.row_height(j) + half, heights.high);
      row.share = static_cast<float>((high - low) / (2.0 * half));
      radius[k] = -1.0f;
      if (high <= low) continue;
      extent[k] = side == WallSide::outside ? clay.outer_most(j) : clay.inner_least(j);
      if (side == WallSide::outside ? window.nearest > double{extent[k]}
                                    : window.farthest < double{extent[k]})
        continue;
      row.y = 0.5 * (low + high);
      row.outline = body.outline(row.y);
      const Circle circle = row.outline.circle();
      if (circle.radius <= 0.0) continue;
      if (circle.x != last.x || circle.z != last.z) {
        last = circle;
        last_angle = portable::atan2(circle.z, circle.x);
      }
      angle[k] = last_angle;
      const double away = std::sqrt(circle.x * circle.x + circle.z * circle.z);
      row.sector = static_cast<float>(2.0 * portable::kPi / clay.sectors());
      distance[k] = static_cast<float>(away);
      radius[k] = static_cast<float>(circle.radius);
      tangent[k] = static_cast<float>(cross_section(away, circle.radius));
      tangent[k] = tangent[k] > 0.0f ? tangent[k] : 0.0f;
    }
    float half[kLanes];
    store(half_window<side>(load(distance), load(radius), load(tangent), load(extent)), half);
    // Rows where an upright tool is cut alike are given the angles of the one that it reaches
    // farthest, and worked out once: an element more there costs less than its own arc tangents.
    int like = -1;
    Turn both;
    for (int k = 0; k < count; ++k) {
      if (radius[k] <= 0.0f || half[k] < 0.0f) continue;
      if (like < 0 || !(rows[k].outline == rows[like].outline)) {
        like = k;
        double most = double{extent[k]};
        double widest = double{half[k]};
        for (int n = k + 1; n < count; ++n) {
          if (radius[n] <= 0.0f || half[n] < 0.0f || !(rows[n].outline == rows[k].outline))
            continue;
          most = side == WallSide::outside ? std::max(most, double{extent[n]})
                                           : std::min(most, double{extent[n]});
          widest = std::max(widest, double{half[n]});
        }
        both = turn_of(rows[k].outline, side, most, overlap({angle[k], widest}, window.turn));
      }
      if (both.half < 0.0) continue;
      const double per_radian = clay.sectors() / (2.0 * portable::kPi);
      const double middle = both.middle * per_radian - 0.5;
      // Elements that are covered in part lie up to half a width beyond; one more for the rounding.
      const double reach = both.half * per_radian + 0.5;
      set_ranges(rows[k], static_cast<int>(std::floor(middle - reach)),
                 static_cast<int>(std::floor(middle + reach)) + 1, clay.sectors(),
                 clay.stride() / kLanes);
    }
  }

  HWY_INLINE void collect(const RowSum& sum, float area, Reaction& total) const {
    const Float8 share_of = all(area);
    total.normal = total.normal + sum.weight * share_of;
    total.x = total.x + sum.x * share_of;
    total.y = total.y + sum.y * share_of;
    total.z = total.z + sum.z * share_of;
  }

  auto row(double, const SolidReach& reach) const {
    return SolidRow<decltype(body.cut(0.0))>{body.cut(reach.y), reach.outline, reach.sector,
                                             reach.share};
  }
};

}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
