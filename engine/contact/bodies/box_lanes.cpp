#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct BoxShape {
  using Body = body::Box;

  template <WallSide side>
  ONGGI_INLINE static FacingInterval interval(const Body::Section& in, Float8 c, Float8 s,
                                              Float8 beside) {
    const FacingInterval upright =
        both<side>(in_slab<side>(in.b, c, s, beside), in_slab<side>(in.c, c, s, beside));
    return in.a.asked ? both<side>(in_slab<side>(in.a, c, s, beside), upright) : upright;
  }
};

}  // namespace

extern const contact::BodyKernel<body::Box> kBox = Kernel<SolidLaw<BoxShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
