#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct CapsuleShape {
  using Body = body::Capsule;

  ONGGI_INLINE static Float8 circle(float radius, float y) {
    const float square = (radius - y) * (radius + y);
    return all(square > 0.0f ? __builtin_sqrtf(square) : 0.0f);
  }
  // What is in any of the balls at its ends and the rod between them.
  template <WallSide side>
  ONGGI_INLINE static FacingInterval interval(const Body::Section& in, Float8 c, Float8 s,
                                              Float8 beside) {
    const RodSection& rod = in.rod;
    const Interval a = in_ball(circle(rod.radius, rod.my), rod.mx, rod.mz, c, s, beside);
    const Interval b = in_ball(circle(rod.radius, in.end_y), in.end_x, in.end_z, c, s, beside);
    const Interval rest = in_rod(rod, c, s, beside);
    const Float8 slope = off_zero(all(rod.ax) * c + all(rod.az) * s);
    const Float8 begin = all(rod.m_along) + beside * (all(rod.az) * c - all(rod.ax) * s);
    const Float8 p = (all(0.0f) - begin) / slope;
    const Float8 q = (all(in.length) - begin) / slope;
    const Float8 near = larger(rest.near, smaller(p, q));
    const Float8 far = smaller(rest.far, larger(p, q));
    const Mask8 met = near < far;
    Interval whole{smaller(a.near, b.near), larger(a.far, b.far)};
    whole.near = smaller(whole.near, select(met, near, all(1e9f)));
    whole.far = larger(whole.far, select(met, far, all(-1e9f)));
    const Float8 t = worked_end<side>(whole);
    const Float8 on = larger(smaller(along_rod(rod, t, c, s, beside), all(in.length)), all(0.0f));
    return facing_rod(rod, whole, t, on, c, s, beside);
  }
};

}  // namespace

extern const contact::BodyKernel<body::Capsule> kCapsule = Kernel<SolidLaw<CapsuleShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
