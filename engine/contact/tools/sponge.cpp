// A sponge: a large soft ball. Size: radius. It gives way itself more than the clay does, and wets
// what it touches.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/sponge.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/tools/sphere_rows.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

ONGGI_PRESS_WITH(Sphere)

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi {

ONGGI_CHOOSE_VECTORS()

extern const ToolShape kTool_sponge{
    .name = "sponge",
    .usual = {.radius = 0.03},
    .least = {.radius = 0.01},
    .most = {.radius = 0.05},
    .round = true,
    .softness = 0.15,
    .wets = true,
    .smooths = true,
    .reach = ball_reach,
    .grain = radius_grain,
    .ball = own_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
