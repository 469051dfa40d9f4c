// A ball: the paper's own tool (Lee, Han & Choi 2008). Size: radius.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/sphere.cpp"
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

extern const ToolShape kTool_sphere{
    .name = "sphere",
    .usual = {.radius = 0.008},
    .least = {.radius = 0.001},
    .most = {.radius = 0.05},
    .round = true,
    .reach = ball_reach,
    .grain = radius_grain,
    .ball = own_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
