// A ball's section with a row: a circle. Compiled once for each kind of vector: include it only
// from such a file.
#if defined(ONGGI_CONTACT_TOOLS_SPHERE_ROWS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ONGGI_CONTACT_TOOLS_SPHERE_ROWS_H
#undef ONGGI_CONTACT_TOOLS_SPHERE_ROWS_H
#else
#define ONGGI_CONTACT_TOOLS_SPHERE_ROWS_H
#endif

#include "engine/contact/press_rows.h"
#include "engine/contact/tool_balls.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {  // each tool has the kernel to itself, and the compiler can see all of it

// Every end E lies on the sphere, so H - E is radius long: no normal needs a length. The sums are
// those of weight, and of weight times E; H comes in once.
struct SphereRow {
  Float8 section;     // radius of the row's circle; negative where there is none
  Float8 at_x, at_z;  // of its middle
  Float8 edge;        // farthest that an element's ray may pass that is covered in part
  Float8 per_width, most_covered;
  Float8 above;  // H above the row, over the sphere's radius

  template <WallSide side, bool careful>
  HWY_INLINE Meeting meet(Float8 c, Float8 s, Float8) const {
    const Float8 along = at_x * c + at_z * s;
    const Float8 off = at_z * c - at_x * s;
    // Instead of r^2 - s^2: at a tangent ray the squares would cancel.
    const Float8 square = (section - off) * (section + off);
    const Float8 half_chord = sqrt(larger(square, all(0.0f)));
    const Float8 end = side == WallSide::outside ? along - half_chord : along + half_chord;
    if constexpr (!careful) return {end, end, square > all(0.0f)};
    const Float8 inside_edge = edge - abs(off);
    const Mask8 hit = inside_edge > all(0.0f);
    return {end, smaller(inside_edge * per_width, most_covered),
            side == WallSide::outside ? hit & (along > all(0.0f)) : hit};
  }
  HWY_INLINE void react(RowSum& sum, Float8 weight, const Meeting& m, Float8 c, Float8 s) const {
    const Float8 out = weight * m.end;
    sum.weight = sum.weight + weight;
    sum.x = sum.x + out * c;
    sum.y = sum.y + weight * above;
    sum.z = sum.z + out * s;
  }
};

struct Sphere {
  double radius;
  float at_x, at_z;
  float x, z, per_radius;  // of H from the axis, over the sphere's radius

  Sphere(const ToolPlace& place, const ToolSize& size)
      : radius(size.radius),
        at_x(static_cast<float>(place.at.x)),
        at_z(static_cast<float>(place.at.z)),
        x(static_cast<float>(place.at.x / size.radius)),
        z(static_cast<float>(place.at.z / size.radius)),
        per_radius(static_cast<float>(1.0 / size.radius)) {}
  double reach() const { return radius; }
  HWY_INLINE SphereRow row(double, const RowReach& reach) const {
    const float narrow = 2.0f * reach.section * reach.per_width;
    return {all(reach.section),
            all(at_x),
            all(at_z),
            all(reach.section + 0.5f * reach.width),
            all(reach.per_width),
            all(narrow < 1.0f ? narrow : 1.0f),
            all(reach.above * per_radius)};
  }
  HWY_INLINE void collect(const RowSum& sum, float area, Reaction& total) const {
    const Float8 weight = sum.weight * all(area);
    const Float8 share = all(area * per_radius);
    total.normal = total.normal + weight;
    total.x = total.x + (weight * all(x) - sum.x * share);
    total.y = total.y + sum.y * all(area);
    total.z = total.z + (weight * all(z) - sum.z * share);
  }
};

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
