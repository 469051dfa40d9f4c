// A needle in a handle: incises lines and trims rims. Sizes: radius of its point and length. `at`
// is the middle of the point; the needle lies along. It is thinner than most elements: those it
// meets give way for the share that it covers, so that a line is at least one element wide.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/needle.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/press_rows.h"
#include "engine/contact/tools/bodies.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

ONGGI_PRESS_WITH(Solid<Capsule>)

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi {

ONGGI_CHOOSE_VECTORS()

extern const ToolShape kTool_needle{
    .name = "needle",
    .usual = {.radius = 0.0006, .length = 0.06},
    .least = {.radius = 0.0002, .length = 0.005},
    .most = {.radius = 0.003, .length = 0.2},
    .hold = {.along = {0.8, 0.6, 0.0}, .across = {0.0, 0.0, 1.0}},
    .relaxation = 0.2,
    .cuts = true,
    .reach = capsule_reach,
    .grain = radius_grain,
    .ball = capsule_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
