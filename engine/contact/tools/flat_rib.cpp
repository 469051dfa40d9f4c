// A flat rib: a thin plate of wood or steel. Sizes: length, radius (half its width) and thickness.
// `at` is its middle. Held upright with its face to the wall it makes the wall straight; with the
// wheel still it makes facets.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "engine/contact/tools/flat_rib.cpp"
#include <hwy/foreach_target.h>

#include "engine/contact/press_rows.h"
#include "engine/contact/tools/bodies.h"

HWY_BEFORE_NAMESPACE();
namespace onggi::HWY_NAMESPACE {
namespace {

ONGGI_PRESS_WITH(Solid<Plate>)

}  // namespace
}  // namespace onggi::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace onggi {

ONGGI_CHOOSE_VECTORS()

extern const ToolShape kTool_flat_rib{
    .name = "flat_rib",
    .usual = {.radius = 0.02, .length = 0.09, .thickness = 0.003},
    .least = {.radius = 0.005, .length = 0.02, .thickness = 0.001},
    .most = {.radius = 0.06, .length = 0.25, .thickness = 0.02},
    .hold = {.along = {0.0, 1.0, 0.0}, .across = {1.0, 0.0, 0.0}},
    .smooths = true,
    .reach =
        [](const ToolSize& size) {
          return length(Vec3{0.5 * size.length, size.radius, 0.5 * size.thickness});
        },
    .grain = thickness_grain,
    .ball = plate_ball,
    .press = press,
    .depth = depth,
};

}  // namespace onggi
#endif
