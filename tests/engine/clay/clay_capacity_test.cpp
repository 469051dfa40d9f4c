#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "engine/clay/clay_view.h"

namespace onggi::clay_capacity_test {
namespace {

constexpr double kTurn = 2.0 * 3.14159265358979323846;

/// A pot of `rows` by `sectors` that is hollow as `inner(height, angle)` says, over a floor of 10
/// mm.
ClayView pot(double height, const std::function<double(double, double)>& inner, int rows = 400,
             int sectors = 360) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  def.height = height;
  def.floor_thickness = 0.01;
  ClayView clay;
  clay.lay(def);
  for (int j = clay.floor_rows(); j < rows; ++j) {
    std::vector<float> in, out;
    for (int i = 0; i < sectors; ++i) {
      in.push_back(static_cast<float>(inner(clay.row_height(j), kTurn * (i + 0.5) / sectors)));
      out.push_back(in.back() + 0.006f);
    }
    clay.shape(j, out, in);
  }
  return clay;
}

double held(const ClayView& clay) { return clay.capacity(); }

void tear(ClayView& clay, int row) {
  clay.place(row,
             {clay.row_height(row), clay.rim_height(), clay.floor_top(), clay.floor_rows(), true});
}

TEST(Capacity, OfACylinderIsItsAreaTimesItsDepthFromATenthOfALitreToThree) {
  for (const auto& [radius, height] : {std::pair{0.02, 0.0896}, {0.05, 0.1373}, {0.0725, 0.1917}}) {
    const double exact = 0.5 * kTurn * radius * radius * (height - 0.01);
    EXPECT_NEAR(held(pot(height, [r = radius](double, double) { return r; })) / exact, 1.0, 1e-6)
        << exact * 1000 << " litres";
  }
}

TEST(Capacity, OfAConeAndOfABowlAreThoseOfTheSolids) {
  const ClayView cone = pot(0.16, [](double h, double) { return 0.02 + 0.3 * (h - 0.01); });
  const double wide = 0.02 + 0.3 * 0.15;
  EXPECT_NEAR(cone.capacity() / (kTurn / 6 * 0.15 * (0.0004 + 0.02 * wide + wide * wide)), 1.0,
              1e-4);
  // A paraboloid holds half of the cylinder round it.
  const ClayView bowl =
      pot(0.11, [](double h, double) { return 0.1 * std::sqrt((h - 0.01) / 0.1); });
  EXPECT_NEAR(bowl.capacity() / (0.25 * kTurn * 0.01 * 0.1), 1.0, 1e-4);
}

TEST(Capacity, OfAnOvalIsItsOwnAndNotThatOfItsMeanRadius) {
  const double a = 0.03, b = 0.06;
  const auto oval = [&](double, double angle) {
    return a * b / std::hypot(b * std::cos(angle), a * std::sin(angle));
  };
  EXPECT_NEAR(held(pot(0.11, oval)) / (0.5 * kTurn * a * b * 0.1), 1.0, 1e-5);
}

TEST(Capacity, IsWhatIsHeldBelowTheLowestTear) {
  const auto straight = [](double, double) { return 0.04; };
  ClayView torn = pot(0.11, straight, 110);
  tear(torn, 80);
  tear(torn, 60);
  EXPECT_NEAR(torn.capacity() / (0.5 * kTurn * 0.0016 * 0.05), 1.0, 0.011) << "a row is 1 mm";
  tear(torn, torn.floor_rows());
  EXPECT_EQ(torn.capacity(), 0.0);
}

TEST(Capacity, OfNoClayAndOfASolidLumpIsNothing) {
  EXPECT_EQ(ClayView().capacity(), 0.0);
  EXPECT_NEAR(held(pot(0.1, [](double, double) { return 0.0; })), 0.0, 1e-12);
}

// Where rows went up and down, each is as high as to half-way to its neighbours.
TEST(Capacity, OfRowsThatAreNotEvenlyHighIsTheSame) {
  ClayView clay = pot(
      0.11, [](double, double) { return 0.05; }, 110);
  for (int j = clay.floor_rows(); j < clay.rows(); ++j)
    clay.place(j, {0.0105 + 0.1 * std::pow((j - clay.floor_rows()) / 100.0, 1.5), 0.12,
                   clay.floor_top(), clay.floor_rows(), false});
  EXPECT_NEAR(clay.capacity() / (0.5 * kTurn * 0.0025 * 0.11), 1.0, 1e-5);
}

}  // namespace
}  // namespace onggi::clay_capacity_test
