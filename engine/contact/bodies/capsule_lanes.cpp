#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct CapsuleShape {
  using Body = body::Capsule;
  static constexpr bool kLeans = true;
  // Elements do not resolve the print of a thinner one, as of a needle.
  static constexpr float kThin = 0.002f;  // m
  bool thick;
  RodLanes rod;
  Float8 length, end_x, end_z;
  Float8 tip_circle, end_circle;  // radii of the balls' sections

  ONGGI_INLINE explicit CapsuleShape(const Body::Section& in)
      : thick(in.rod.radius >= kThin),
        rod(in.rod),
        length(all(in.length)),
        end_x(all(in.end_x)),
        end_z(all(in.end_z)),
        tip_circle(circle(in.rod.radius, in.rod.my)),
        end_circle(circle(in.rod.radius, in.end_y)) {}

  ONGGI_INLINE bool leans() const { return thick; }
  ONGGI_INLINE Float8 over_radius() const { return rod.over_radius; }
  ONGGI_INLINE static Float8 circle(float radius, float y) {
    const float square = (radius - y) * (radius + y);
    return all(square > 0.0f ? __builtin_sqrtf(square) : 0.0f);
  }
  // The union of the two end balls and the rod between them.
  template <WallSide side>
  ONGGI_INLINE FacingInterval interval(Float8 c, Float8 s, Float8 beside) const {
    const Interval a = in_ball(tip_circle, rod.mx, rod.mz, c, s, beside);
    const Interval b = in_ball(end_circle, end_x, end_z, c, s, beside);
    const Interval rest = in_rod(rod, c, s, beside);
    const Float8 slope = off_zero(rod.ax * c + rod.az * s);
    const Float8 begin = rod.m_along + beside * (rod.az * c - rod.ax * s);
    const Float8 p = (all(0.0f) - begin) / slope;
    const Float8 q = (length - begin) / slope;
    const Float8 near = larger(rest.near, smaller(p, q));
    const Float8 far = smaller(rest.far, larger(p, q));
    const Mask8 met = near < far;
    Interval whole{smaller(a.near, b.near), larger(a.far, b.far)};
    whole.near = smaller(whole.near, select(met, near, all(1e9f)));
    whole.far = larger(whole.far, select(met, far, all(-1e9f)));
    const Float8 t = worked_end<side>(whole);
    const Float8 on = larger(smaller(along_rod(rod, t, c, s, beside), length), all(0.0f));
    return facing_rod(rod, whole, t, on, c, s, beside);
  }
};

}  // namespace

extern const contact::BodyKernel<body::Capsule> kCapsule = Kernel<SolidLaw<CapsuleShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
