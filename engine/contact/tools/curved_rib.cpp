// A curved rib: a disc whose rim shapes the wall to its own curve. Sizes: radius and thickness.
// `at` is its middle. Held upright and edge on, it works as well inside as outside.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/curved_rib.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/press_rows.h"
#include "engine/contact/tools/bodies.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

ONGGI_PRESS_WITH(Solid<Disc>)

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi {

ONGGI_CHOOSE_VECTORS()

extern const ToolShape kTool_curved_rib{
    .name = "curved_rib",
    .usual = {.radius = 0.04, .thickness = 0.004},
    .least = {.radius = 0.01, .thickness = 0.001},
    .most = {.radius = 0.1, .thickness = 0.02},
    .hold = {.along = {0.0, 1.0, 0.0}, .across = {0.0, 0.0, 1.0}},
    .smooths = true,
    .reach = disc_reach,
    .grain = thickness_grain,
    .ball = disc_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
