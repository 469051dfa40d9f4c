// A cutting wire: taut between two hands, it cuts the pot from the wheel. Sizes: radius and length.
// `at` is its middle. It presses nothing; what it cuts is engine/contact/wire.h's to say.
#include "engine/contact/tool_balls.h"

namespace onggi {

extern const ToolShape kTool_wire{
    .name = "wire",
    .usual = {.radius = 0.0005, .length = 0.4},
    .least = {.radius = 0.0001, .length = 0.1},
    .most = {.radius = 0.002, .length = 1.0},
    .hold = {.along = {0.0, 0.0, 1.0}, .across = {0.0, 1.0, 0.0}},
    .cuts = true,
    .severs = true,
    .reach = [](const ToolSize& size) { return 0.5 * size.length + size.radius; },
    .grain = radius_grain,
    .ball = own_ball,
    .press = [](Clay&, WallSide, const ToolPlace&, const ToolSize&, double,
                const Yielding&) { return Press{}; },
    .depth = [](const Clay&, WallSide, const ToolPlace&, const ToolSize&,
                std::int64_t&) { return 0.0; },
};

}  // namespace onggi
