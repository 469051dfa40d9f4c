#include "engine/contact/solid_window.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/contact/tool.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "engine/math/unit.h"
#include "tests/support/any_direction.h"

namespace onggi::contact::solid_window_test {
namespace {

Vec3 turned(Vec3 v, double angle) {
  const double c = portable::cos(angle);
  const double s = portable::sin(angle);
  return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

TEST(SolidWindow, HoldsWhatTheToolPressesWhicheverWayItIsFromTheAxis) {
  // Turned by whole elements, a pose takes as much clay: of bodies as wide as the pot too, which
  // reach across the half-line where angles begin anew.
  constexpr int kSectors = 40;
  ClayDef def;
  def.rows = 30;
  def.sectors = kSectors;
  Random random(11);
  int pressed = 0;
  for (const char* name :
       {"flat_rib", "curved_rib", "loop_trimmer", "needle", "fingertip", "sphere", "sponge"}) {
    const ToolShape& shape = *find_tool_shape(name);
    for (int n = 0; n < 40; ++n) {
      const ToolSize& size = n % 2 == 0 ? shape.usual : shape.most;
      const Vec3 along = test::any_direction(random);
      const Vec3 across = cross(along, test::any_direction(random));
      const Vec3 at{random.uniform(-0.09, 0.09), random.uniform(0.0, 0.2),
                    random.uniform(-0.09, 0.09)};
      const WallSide side = n % 4 < 2 ? WallSide::outside : WallSide::inside;
      double first = 0.0;
      for (int k = 0; k < kSectors; ++k) {
        const double angle = 2.0 * portable::kPi * k / kSectors;
        const ToolPlace place{turned(at, angle), turned(along, angle), turned(unit(across), angle)};
        Clay clay = std::move(*Clay::create(def));
        const Press press = shape.press(clay, side, place, size, 0.001, {0.00949, 5e6});
        EXPECT_GE(press.visited, press.touched);
        if (k == 0) first = press.normal;
        EXPECT_NEAR(press.normal, first, 2e-3 * first + 1e-3) << name << ' ' << n << ' ' << k;
        pressed += press.touched > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(pressed, 2000);
}

// How many elements are looked at for each that is pressed, over many poses of a tool deep in a
// wall.
double looked_at(const char* name) {
  ClayDef def;
  def.rows = 200;
  def.sectors = 1440;
  Clay clay = std::move(*Clay::create(def));
  const ToolShape& shape = *find_tool_shape(name);
  Random random(17);
  double visited = 0.0;
  double touched = 0.0;
  for (int n = 0; n < 60; ++n) {
    const Vec3 along = test::any_direction(random);
    const Vec3 across = cross(along, test::any_direction(random));
    const Vec3 at = turned({0.056, 0.1, 0.0}, random.uniform(0.0, 2.0 * portable::kPi));
    const ToolPlace place{at, along, unit(across)};
    // So quick that the wall stays as it is.
    const Press press = shape.press(clay, WallSide::outside, place, shape.usual, 1e-9, {0.01, 5e6});
    visited += static_cast<double>(press.visited);
    touched += static_cast<double>(press.touched);
  }
  EXPECT_GT(touched, 1000.0) << name;
  return visited / touched;
}

TEST(SolidWindow, LooksAtLittleMoreThanWhatIsPressed) {
  // A needle is thinner than a block of eight elements is wide. The same on every machine: a bound
  // that is passed says that a window has grown.
  EXPECT_LT(looked_at("flat_rib"), 1.217);
  EXPECT_LT(looked_at("curved_rib"), 1.122);
  EXPECT_LT(looked_at("fingertip"), 1.385);
  EXPECT_LT(looked_at("loop_trimmer"), 1.405);
  EXPECT_LT(looked_at("needle"), 6.0);
}

TEST(SolidWindow, PlansRowsThatAnUprightBlockCutsAlikeAsIfEachWereAsked) {
  constexpr int kCount = 8;
  ClayDef def;
  def.rows = 40;
  def.sectors = 90;
  Clay clay = std::move(*Clay::create(def));
  Random random(5);
  for (int j = 0; j < def.rows; ++j)  // no two rows reach as far
    clay.set_extent(j, static_cast<float>(random.uniform(0.04, 0.06)),
                    static_cast<float>(random.uniform(0.02, 0.03)));
  int planned = 0;
  for (int n = 0; n < 400; ++n) {
    const double turn = random.uniform(0.0, 2.0 * portable::kPi);
    const Vec3 middle = turned({random.uniform(0.005, 0.07), 0.1, 0.0}, turn);
    const double tilt = turn + random.uniform(-0.5, 0.5);
    const body::Box box{middle,
                        {Vec3{0, 1, 0}, turned({1, 0, 0}, tilt), turned({0, 0, 1}, tilt)},
                        {0.05, random.uniform(0.0005, 0.02), random.uniform(0.0005, 0.02)}};
    ASSERT_TRUE(box.upright());
    const WallSide side = n % 2 == 0 ? WallSide::outside : WallSide::inside;
    const SolidWindow window(clay, box.heights(), box.hull(), box.approach(), middle);
    const int first = 10 + n % 15;
    bool covered[kCount];
    SolidReach each[kCount];
    SolidReach alike[kCount];
    for (int k = 0; k < kCount; ++k) {
      covered[k] = cover_row(clay, window, side, first + k, each[k]);
      each[k].outline = box.outline(middle.y);
      cover_row(clay, window, side, first + k, alike[k]);
    }
    plan_rows(clay, window, side, first, kCount, covered, each);
    plan_alike_rows(clay, window, side, AlikeRows(box.outline(middle.y)), first, kCount, covered,
                    alike);
    for (int k = 0; k < kCount; ++k) {
      ASSERT_EQ(alike[k].used, each[k].used) << n << ' ' << k;
      planned += each[k].used > 0 ? 1 : 0;
      for (int r = 0; r < each[k].used; ++r) {
        EXPECT_EQ(alike[k].ranges[r].begin, each[k].ranges[r].begin) << n << ' ' << k;
        EXPECT_EQ(alike[k].ranges[r].end, each[k].ranges[r].end) << n << ' ' << k;
      }
    }
  }
  EXPECT_GT(planned, 1000);
}

}  // namespace
}  // namespace onggi::contact::solid_window_test
