#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct CylinderShape {
  using Body = body::Cylinder;

  template <WallSide side>
  ONGGI_INLINE static FacingInterval interval(const Body::Section& in, Float8 c, Float8 s,
                                              Float8 beside) {
    const Interval round = in_rod(in.rod, c, s, beside);
    const Float8 t = worked_end<side>(round);
    const FacingInterval facing =
        facing_rod(in.rod, round, t, along_rod(in.rod, t, c, s, beside), c, s, beside);
    return both<side>(facing, in_slab<side>(in.faces, c, s, beside));
  }
};

}  // namespace

extern const contact::BodyKernel<body::Cylinder> kCylinder = Kernel<SolidLaw<CylinderShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
