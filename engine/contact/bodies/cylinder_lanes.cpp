#include "engine/contact/bodies/solid_lanes.h"

namespace onggi::ONGGI_LANES {
namespace {

struct CylinderShape {
  using Body = body::Cylinder;
  static constexpr bool kLeans = false;
  RodLanes rod;
  SlabLanes faces;

  ONGGI_INLINE explicit CylinderShape(const Body::Section& in) : rod(in.rod), faces(in.faces) {}

  template <WallSide side>
  ONGGI_INLINE FacingInterval interval(Float8 c, Float8 s, Float8 beside) const {
    const Interval round = in_rod(rod, c, s, beside);
    const Float8 t = worked_end<side>(round);
    const FacingInterval facing =
        facing_rod(rod, round, t, along_rod(rod, t, c, s, beside), c, s, beside);
    return both<side>(facing, in_slab<side>(faces, c, s, beside));
  }
};

}  // namespace

extern const contact::BodyKernel<body::Cylinder> kCylinder = Kernel<SolidLaw<CylinderShape>>::kAll;

}  // namespace onggi::ONGGI_LANES
