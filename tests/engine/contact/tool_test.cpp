#include "engine/contact/tool.h"

#include <gtest/gtest.h>

#include <iterator>
#include <string_view>

#include "tests/support/sphere.h"

namespace onggi::tool_test {
namespace {

TEST(Sponge, IsABallToTheClay) {
  const ToolShape& sponge = *find_tool_shape("sponge");
  Clay one = std::move(*Clay::create({}));
  Clay other = one;
  const Press a = sponge.press(one, WallSide::outside, {{0.08, 0.1, 0.01}}, {0.03, 0, 0}, 0.001,
                               {0.00949, 5e6});
  const Press b =
      press_sphere(other, WallSide::outside, {0.08, 0.1, 0.01}, 0.03, 0.001, {0.00949, 5e6});
  EXPECT_EQ(a.force, b.force);
  EXPECT_EQ(one.hash(), other.hash());
}

// What scenes and replays count on that name a tool and no size.
TEST(Tools, AreAsLargeAsTheirPageSaysAndNoLargerOrSmallerThanItAllows) {
  struct Size {
    std::string_view name;
    ToolSize usual, least, most;
    double softness, relaxation;
    std::string_view does;
  };
  const Size sizes[] = {
      {"curved_rib", {.04, 0, .004}, {.01, 0, .001}, {.1, 0, .02}, 1, 1, "smooths"},
      {"fingertip", {.008, .022, 0}, {.003, .001, 0}, {.02, .08, 0}, 1, 1, ""},
      {"flat_rib", {.02, .09, .003}, {.005, .02, .001}, {.06, .25, .02}, 1, 1, "smooths"},
      {"loop_trimmer", {.008, 0, .003}, {.002, 0, .0005}, {.04, 0, .01}, 1, .2, "cuts"},
      {"needle", {.0006, .06, 0}, {.0002, .005, 0}, {.003, .2, 0}, 1, .2, "cuts"},
      {"palm", {.018, 0, 0}, {.01, 0, 0}, {.05, 0, 0}, 1, 1, "smooths"},
      {"sphere", {.008, 0, 0}, {.001, 0, 0}, {.05, 0, 0}, 1, 1, ""},
      {"sponge", {.03, 0, 0}, {.01, 0, 0}, {.05, 0, 0}, .15, 1, "wets smooths"},
      {"wire", {.0005, .4, 0}, {.0001, .1, 0}, {.002, 1, 0}, 1, 1, "cuts"},
  };
  ASSERT_EQ(tool_shapes().size(), std::size(sizes));
  const auto same = [](const ToolSize& a, const ToolSize& b) {
    return a.radius == b.radius && a.length == b.length && a.thickness == b.thickness;
  };
  for (std::size_t n = 0; n < std::size(sizes); ++n) {
    const ToolShape& is = tool_shapes()[n];
    const Size& told = sizes[n];
    EXPECT_EQ(is.name, told.name);
    EXPECT_TRUE(same(is.usual, told.usual)) << told.name;
    EXPECT_TRUE(same(is.least, told.least)) << told.name;
    EXPECT_TRUE(same(is.most, told.most)) << told.name;
    EXPECT_EQ(is.softness, told.softness) << told.name;
    EXPECT_EQ(is.relaxation, told.relaxation) << told.name;
    const auto does = [&](const char* what) {
      return told.does.find(what) != std::string_view::npos;
    };
    EXPECT_EQ(is.cuts, does("cuts")) << told.name;
    EXPECT_EQ(is.wets, does("wets")) << told.name;
    EXPECT_EQ(is.smooths, does("smooths")) << told.name;
  }
}

TEST(Hold, IsByUnitDirectionsAtRightAnglesForEveryToolAndByDefault) {
  const auto expect_frame = [](Vec3 along, Vec3 across, std::string_view what) {
    EXPECT_NEAR(dot(along, along), 1.0, 1e-12) << what;
    EXPECT_NEAR(dot(across, across), 1.0, 1e-12) << what;
    EXPECT_NEAR(dot(along, across), 0.0, 1e-12) << what;
  };
  ASSERT_FALSE(tool_shapes().empty());
  for (const ToolShape& tool : tool_shapes())
    expect_frame(tool.hold.along, tool.hold.across, tool.name);
  expect_frame(ToolPlace{}.along, ToolPlace{}.across, "a place");
  expect_frame(Hold{}.along, Hold{}.across, "a hold");
  expect_frame(ToolSweep{}.along, ToolSweep{}.across, "a sweep");
}

// Two springs in a row: pressed as far as a firm ball, it is felt for its softness, and the clay
// gives way that much more slowly.
// A fingertip leans outwards. On the axis there is no outwards, and it would turn round from one
// side to the other: 2.3 N in a tick.
TEST(Hold, OfATrembleOnTheAxisKeepsALeaningToolAsItIs) {
  for (const char* name : {"fingertip", "needle"})
    for (const bool inside : {false, true}) {
      const ToolShape& tool = *find_tool_shape(name);
      const auto along = [&](Vec3 at) { return hold_tool(tool, at, {}, 0.0, inside).along; };
      for (double x = -0.012; x < 0.012; x += 2e-5)
        EXPECT_LT(length(along({x + 2e-5, 0.1, 1e-6}) - along({x, 0.1, 1e-6})), 0.008) << name << x;
      EXPECT_EQ(along({0.0, 0.1, 0.0}).y, 1.0);
      EXPECT_NEAR(along({0.0081, 0.1, 0.0}).x,
                  (inside ? -1.0 : 1.0) * (std::string(name) == "needle" ? 0.8 : 0.5), 1e-12);
    }
}

TEST(Sponge, IsFeltSofterAndDentsTheClayMoreSlowlyThanAFirmBall) {
  const auto pressed = [](const char* name, Clay& clay) {
    ToolSweep sweep = sweep_sphere({0.0845, 0.1, 0.0}, {0.0845, 0.1, 0.0}, 0.03);
    sweep.shape = find_tool_shape(name);
    ToolContact contact;
    contact.begin_tick();
    contact.step(clay, sweep, 0, 1, {0.00949, 5e6});
    return contact.reaction().force.x;
  };
  Clay soft = std::move(*Clay::create({}));
  Clay firm = soft;
  const double share = find_tool_shape("sponge")->softness;
  EXPECT_NEAR(pressed("sponge", soft) / pressed("sphere", firm), share, 0.06 * share);
  const auto dent = [](const Clay& clay) {
    return 0.055 - double{clay.outer(clay.first_row_above(0.1))[0]};
  };
  EXPECT_NEAR(dent(soft) / dent(firm), share, 0.06 * share);
}

// What a firm tool presses for ten relaxation times, a blade has through at once, and with less
// force.
TEST(LoopTrimmer, GivesTheClayLessTimeThanARib) {
  EXPECT_LT(find_tool_shape("loop_trimmer")->relaxation, 0.5);
  EXPECT_TRUE(find_tool_shape("loop_trimmer")->cuts);
  EXPECT_FALSE(find_tool_shape("curved_rib")->cuts);
}

}  // namespace
}  // namespace onggi::tool_test
