// What a block of eight sectors meets where eight sectors are a third or a half of the circle.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/contact/tool.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"

namespace onggi::coarse_grid_test {
namespace {

constexpr Yielding kClay{0.00949, 5e6};
constexpr float kRounding = 3e-8f;

Clay coarse(int sectors, Vectors kind = best_vectors()) {
  ClayDef def;
  def.rows = 24;
  def.sectors = sectors;
  def.height = 0.06;
  def.outer_radius = 0.05;
  def.inner_radius = 0.02;
  def.radius_min = 0.0005;
  def.wall_min = 0.001;
  return std::move(*Clay::create(def, kind));
}

void expect_within_limits(const Clay& clay) {
  const ClayDef& def = clay.def();
  for (int j = 0; j < clay.rows(); ++j)
    for (std::size_t i = 0; i < clay.outer(j).size(); ++i) {
      const float least = j < clay.floor_rows() ? 0.0f : static_cast<float>(def.radius_min);
      ASSERT_GE(clay.inner(j)[i], least - kRounding) << j << ' ' << i;
      ASSERT_GE(clay.outer(j)[i] - clay.inner(j)[i], float(def.wall_min) - kRounding)
          << j << ' ' << i;
      ASSERT_GE(clay.outer(j)[i], float(def.radius_min + def.wall_min) - kRounding)
          << j << ' ' << i;
      ASSERT_LE(clay.outer(j)[i], float(def.radius_max) + kRounding) << j << ' ' << i;
    }
}

TEST(CoarseGrid, ALargeBallInTheWallLeavesTheFarHalfOfItAlone) {
  for (int sectors = 16; sectors <= 30; ++sectors)
    for (int place = 0; place < sectors; ++place) {
      Clay clay = coarse(sectors);
      const double angle = 2.0 * portable::kPi * (place + 0.3) / sectors;
      const Vec3 at{0.09 * std::cos(angle), 0.03, 0.09 * std::sin(angle)};
      find_tool_shape("sphere")->press(clay, WallSide::outside, {at}, {0.05, 0.0, 0.0}, 0.001,
                                       kClay);
      const int row = clay.first_row_above(0.03);
      for (std::size_t i = 0; i < clay.outer(row).size(); ++i) {
        const double there = (static_cast<double>(i) + 0.5) * 2.0 * portable::kPi / sectors;
        const double way = std::remainder(there - angle, 2.0 * portable::kPi);
        if (std::fabs(way) > 0.5 * portable::kPi) {
          ASSERT_EQ(clay.outer(row)[i], 0.05f) << sectors << ", " << place << ": element " << i;
        } else if (std::fabs(way) < 0.2) {
          ASSERT_LT(clay.outer(row)[i], 0.05f) << sectors << ", " << place << ": element " << i;
        }
      }
    }
}

TEST(CoarseGrid, NoBodyOfAnySizePullsAnElementThroughTheAxis) {
  Random random(11);
  for (const ToolShape& shape : tool_shapes())
    for (int sectors = 16; sectors <= 144; sectors += sectors < 32 ? 1 : 7)
      for (int round = 0; round < 6; ++round) {
        Clay clay = coarse(sectors);
        const auto between = [&](double least, double most) { return random.uniform(least, most); };
        const ToolSize size{between(shape.least.radius, shape.most.radius),
                            between(shape.least.length, shape.most.length),
                            between(shape.least.thickness, shape.most.thickness)};
        const WallSide side = round % 3 == 2 ? WallSide::inside : WallSide::outside;
        for (int press = 0; press < 6; ++press) {
          const double angle = between(0.0, 6.28);
          const double out = between(0.0, 0.06 + size.radius);
          const Vec3 at{out * std::cos(angle), between(0.0, 0.06), out * std::sin(angle)};
          const Vec3 handle =
              press % 2 == 0 ? Vec3{} : Vec3{between(-1, 1), between(-1, 1), between(-1, 1)};
          const ToolPlace place =
              hold_tool(shape, at, handle, between(0.0, 6.28), side == WallSide::inside);
          for (int n = 0; n < 12; ++n) shape.press(clay, side, place, size, 0.004, kClay);
        }
        ASSERT_NO_FATAL_FAILURE(expect_within_limits(clay))
            << shape.name << ", " << sectors << " sectors";
      }
}

}  // namespace
}  // namespace onggi::coarse_grid_test
