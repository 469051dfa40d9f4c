// A finger's last joint: round at its tip, straight behind. Sizes: radius, and length from the
// middle of the tip to the middle of the knuckle. `at` is the middle of the tip; the finger lies
// along.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/fingertip.cpp"
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

extern const ToolShape kTool_fingertip{
    .name = "fingertip",
    .usual = {.radius = 0.008, .length = 0.022},
    .least = {.radius = 0.003, .length = 0.001},
    .most = {.radius = 0.02, .length = 0.08},
    .hold = {.along = {0.5, 0.86602540378443865, 0.0}, .across = {0.0, 0.0, 1.0}},
    .reach = capsule_reach,
    .grain = radius_grain,
    .ball = capsule_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
