// A loop trimmer: a loop of ribbon at the end of a handle, which carves a groove of the loop's own
// profile. Sizes: radius of the loop, thickness the width of the ribbon. `at` is the middle of the
// loop. What is within the loop comes away with what the ribbon cuts, so that to the clay the loop
// is a disc; the clay comes away at once.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/loop_trimmer.cpp"
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

extern const ToolShape kTool_loop_trimmer{
    .name = "loop_trimmer",
    .usual = {.radius = 0.008, .thickness = 0.003},
    .least = {.radius = 0.002, .thickness = 0.0005},
    .most = {.radius = 0.04, .thickness = 0.01},
    .hold = {.along = {1.0, 0.0, 0.0}, .across = {0.0, 0.0, 1.0}},
    .relaxation = 0.2,
    .cuts = true,
    .reach = disc_reach,
    .grain = thickness_grain,
    .ball = disc_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
