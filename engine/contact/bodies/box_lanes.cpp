#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct BoxShape {
  using Body = body::Box;
  static constexpr bool kLeans = false;
  SlabLanes a, b, c;
  bool asked;

  ONGGI_INLINE explicit BoxShape(const Body::Section& in)
      : a(in.a), b(in.b), c(in.c), asked(in.a.asked) {}

  template <WallSide side>
  ONGGI_INLINE FacingInterval interval(Float8 cos, Float8 sin, Float8 beside) const {
    FacingInterval in =
        both<side>(in_slab<side>(b, cos, sin, beside), in_slab<side>(c, cos, sin, beside));
    if (asked) {
      const FacingInterval last = both<side>(in_slab<side>(a, cos, sin, beside), in);
      // Copy number by number: compilers copy the whole struct through memory.
      in.near = last.near;
      in.far = last.far;
      in.x = last.x;
      in.y = last.y;
      in.z = last.z;
    }
    return in;
  }
};

}  // namespace

extern const contact::BodyKernel<body::Box> kBox = Kernel<SolidLaw<BoxShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
