#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "engine/contact/tool_contact.h"
#include "engine/math/random.h"
#include "tests/engine/contact/cone.h"
#include "tests/support/sphere.h"

// Clay that keeps its shape takes nothing and gives nothing: what a hand puts in on a closed path
// it gets back, whatever the path.
namespace onggi::closed_paths_test {
namespace {

constexpr double kRadius = 0.008;
constexpr Yielding kFrozen{1e6, 5e6};  // it gives way in eleven days

Clay cylinder(double thickness) {
  ClayDef def;
  def.inner_radius = def.outer_radius - thickness;
  return std::move(*Clay::create(def));
}

struct Work {
  double gained = 0.0;  // what the clay gave the hand in all, J
  double stored = 0.0;  // the most that it had put in before, J
};

// Round `path`, straight from place to place, in steps of `step` m. The force between two places is
// the mean of those at both.
Work round(Clay& clay, const std::vector<Vec3>& path, double step = 1e-5,
           std::string_view tool = "sphere", SideWish side = SideWish::by_position) {
  ToolContact contact;
  ToolSweep sweep = sweep_sphere(path[0], path[0], kRadius);
  sweep.shape = find_tool_shape(tool);
  sweep.size = sized(*sweep.shape, {});
  sweep.wish = side;
  Work work;
  Vec3 last;
  for (std::size_t n = 0; n < path.size(); ++n) {
    const Vec3 from = path[n], way = path[(n + 1) % path.size()] - from;
    const int steps = static_cast<int>(std::ceil(length(way) / step));
    for (int k = 1; k <= steps; ++k) {
      const Vec3 at = from + (1.0 * k / steps) * way;
      const ToolPlace held = hold_tool(*sweep.shape, at, {}, 0.0, side == SideWish::inside);
      sweep.from = sweep.to = at;
      sweep.along = held.along;
      sweep.across = held.across;
      contact.begin_tick();
      contact.step(clay, sweep, 0, 1, kFrozen);
      const Vec3 force = contact.reaction().force;
      work.gained += dot(0.5 * (force + last), (1.0 / steps) * way);
      work.stored = std::max(work.stored, -work.gained);
      last = force;
    }
  }
  return work;
}

std::vector<Vec3> over_the_edge(double deep, double from, double to) {
  const double clear = kRim + kRadius + 0.001, low = kRim + kRadius - deep;
  return {{from, clear, 0}, {from, low, 0}, {to, low, 0}, {to, clear, 0}};
}

TEST(ClosedPaths, OverTheEdgeOfTheRimGiveNothing) {
  for (const double thickness : {0.006, 0.020})
    for (const double deep : {0.001, 0.002, 0.004}) {
      Clay clay = cylinder(thickness);
      const double middle = 0.055 - 0.5 * thickness;
      for (const auto& path :
           {over_the_edge(deep, 0.066, middle), over_the_edge(deep, middle, 0.066),
            over_the_edge(deep, 0.034, middle), over_the_edge(deep, middle, 0.034)}) {
        const Work work = round(clay, path);
        EXPECT_GT(work.stored, 1e-5);
        EXPECT_LT(std::fabs(work.gained), 0.01 * work.stored) << thickness << ", " << deep;
      }
    }
}

// The wall's sum ends at the wheel head and at the floor.
TEST(ClosedPaths, AcrossTheWallsEndAtTheFootGiveNothing) {
  for (const double deep : {0.002, 0.004, 0.007}) {
    Clay clay = cylinder(0.010);
    const double out = 0.055 + kRadius, in = 0.045 - kRadius;
    for (const double low : {-0.002, 0.001, 0.004}) {
      const Work work = round(clay, {{out + 0.001, 0.02, 0},
                                     {out - deep, 0.02, 0},
                                     {out - deep, low, 0},
                                     {out + 0.001, low, 0}});
      EXPECT_GT(work.stored, 1e-5);
      EXPECT_LT(std::fabs(work.gained), 0.02 * work.stored) << deep << ", " << low;
      const Work inside = round(clay,
                                {{in - 0.001, 0.03, 0},
                                 {in + deep, 0.03, 0},
                                 {in + deep, 0.0135 + low, 0},
                                 {in - 0.001, 0.0135 + low, 0}},
                                1e-5, "sphere", SideWish::inside);
      EXPECT_LT(std::fabs(inside.gained), 0.02 * inside.stored) << deep << ", " << low;
    }
  }
}

// A fingertip lies aslant: 30 degrees. The sum of its elements' normal forces pushed it up along an
// even wall, and the longer the path, the more it gained.
TEST(ClosedPaths, OfAFingertipThatLeansOnTheWallGiveNothing) {
  for (const double deep : {0.001, 0.003, 0.006}) {
    Clay clay = cylinder(0.020);
    const double out = 0.055 + kRadius;
    for (const double way : {0.03, -0.03}) {
      const Work work = round(clay,
                              {{out + 0.001, 0.1, 0},
                               {out - deep, 0.1, 0},
                               {out - deep, 0.1 + way, 0},
                               {out + 0.001, 0.1 + way, 0}},
                              1e-5, "fingertip");
      EXPECT_GT(work.stored, 1e-5);
      EXPECT_LT(std::fabs(work.gained), 0.03 * work.stored) << deep << ", " << way;
    }
  }
}

// `clear` of the face at height y, in the face's own direction.
Vec3 beside_cone(double slope, double face, double y, double clear, WallSide side) {
  const double way = (side == WallSide::outside ? 1.0 : -1.0) * clear / std::hypot(1.0, slope);
  return {face + slope * (y - 0.5 * kRim) + way, y - slope * way, 0.0};
}

// Elements are weighed by the area that their rays see. A ball on a wall that leans was pushed
// along it, and the longer the path, the more it gained: 90 to 180 % of what the clay stored. Rays
// do not see what the ball hides from them, so the print may reach 75 degrees round.
TEST(ClosedPaths, UpAWallThatLeansGiveNothing) {
  for (const int rows : {200, 400})
    for (const auto& [slope, deep] : {std::pair{-1.0, 0.001},
                                      {-0.6, 0.001},
                                      {-0.3, 0.003},
                                      {0.1, 0.005},
                                      {0.3, 0.003},
                                      {0.6, 0.001},
                                      {1.0, 0.001}})
      for (const WallSide side : {WallSide::outside, WallSide::inside}) {
        const double middle = side == WallSide::outside ? 0.12 : 0.14;
        Clay clay = cone(slope, 0.020, middle, rows);
        const double face = side == WallSide::outside ? middle : middle - 0.020;
        const auto at = [lean = slope, face, side](double y, double clear) {
          return beside_cone(lean, face, y, clear, side);
        };
        const Work work =
            round(clay,
                  {at(0.08, kRadius + 0.001), at(0.08, kRadius - deep), at(0.12, kRadius - deep),
                   at(0.12, kRadius + 0.001)},
                  2e-5, "sphere", side == WallSide::inside ? SideWish::inside : SideWish::outside);
        EXPECT_GT(work.stored, 1e-5);
        EXPECT_LT(std::fabs(work.gained), 0.02 * work.stored)
            << rows << " rows, slope " << slope << ", " << deep << " m deep, "
            << (side == WallSide::outside ? "outside" : "inside");
      }
}

// In below the rim, up past the lip, and back in the clear. The edge's law took the way along the
// ray for the way to the face: 15 to 49 %.
TEST(ClosedPaths, PastTheRimOfAWallThatLeansGiveLittle) {
  for (const auto& [slope, deep, bound] :
       {std::tuple{0.3, 0.001, 0.08}, {-0.8, 0.001, 0.12}, {0.8, 0.001, 0.12}}) {
    Clay clay = cone(slope, 0.012, 0.16);
    const double top = kRim + kRadius + 0.002;
    const Vec3 low = beside_cone(slope, 0.16, kRim - 0.025, kRadius - deep, WallSide::outside);
    const Vec3 high = beside_cone(slope, 0.16, top, kRadius - deep, WallSide::outside);
    const Vec3 clear = beside_cone(slope, 0.16, top, kRadius + 0.001, WallSide::outside);
    const Vec3 back = beside_cone(slope, 0.16, kRim - 0.025, kRadius + 0.001, WallSide::outside);
    const Work work = round(clay, {back, low, high, clear}, 2e-5, "sphere", SideWish::outside);
    EXPECT_GT(work.stored, 1e-6);
    EXPECT_LT(std::fabs(work.gained), bound * work.stored) << slope;
  }
}

// The path that gains most, of those about the rim, by a search uphill from random ones.
TEST(ClosedPaths, NoneThatASearchFindsGainsMoreThanTheSumsAreWrong) {
  struct About {
    double thickness, from, to, lowest;
  };
  for (const About about : {About{0.020, 0.042, 0.068, 0.002}, About{0.020, 0.042, 0.068, -0.012},
                            About{0.020, 0.024, 0.048, 0.002}, About{0.020, 0.024, 0.031, -0.012},
                            About{0.006, 0.034, 0.068, 0.005}}) {
    Random random(11);
    Clay clay = cylinder(about.thickness);
    Work most;
    for (int start = 0; start < 2; ++start) {
      const auto place = [&] {
        return Vec3{random.uniform(about.from, about.to),
                    kRim + random.uniform(about.lowest, 0.012), random.uniform(-0.004, 0.004)};
      };
      const Vec3 clear{0.5 * (about.from + about.to), kRim + 0.012, 0};
      std::vector<Vec3> best{clear, place(), place(), place()};
      Work found = round(clay, best, 5e-5);
      for (int n = 0; n < 60; ++n) {
        std::vector<Vec3> other = best;
        Vec3& moved = other[1 + static_cast<std::size_t>(n % 3)];
        moved = n % 2 == 0 ? place()
                           : moved + 0.002 * Vec3{random.uniform(-1, 1), random.uniform(-1, 1),
                                                  random.uniform(-1, 1)};
        moved.y = std::max(moved.y, kRim + about.lowest);
        const Work work = round(clay, other, 5e-5);
        if (work.gained > found.gained) found = work, best = other;
      }
      if (found.gained > most.gained) most = found;
    }
    // Below the rim the wall's law, which counts elements and their own area, takes over.
    const double bound = about.lowest > 0.0 ? 0.01 : 0.03;
    EXPECT_LT(most.gained, bound * most.stored)
        << about.thickness << " m, from " << about.lowest << ": of " << most.stored << " J";
  }
}

// A flat top is the same clay whether it is called a floor or a rim, and whichever way it faces.
TEST(ClosedPaths, AFlatTopFeelsAlikeAsAFloorAsARimAndAsAWall) {
  for (const double deep : {0.001, 0.002, 0.004}) {
    const auto felt = [&](const ClayDef& def, Vec3 at, Place place) {
      Clay clay = std::move(*Clay::create(def));
      ToolContact contact;
      contact.begin_tick();
      contact.step(clay, sweep_sphere(at, at, kRadius), 0, 1, kFrozen);
      EXPECT_EQ(contact.place(), place);
      return length(contact.reaction().force);
    };
    ClayDef broad;
    broad.sectors = 1440;
    broad.outer_radius = 0.12;
    broad.inner_radius = 0.02;
    const double rim = felt(broad, {0.07, kRim + kRadius - deep, 0}, Place::rim);
    broad.inner_radius = 0.1;
    const double floor = felt(broad, {0.03, 0.010 + kRadius - deep, 0}, Place::floor);
    const double wall = felt(broad, {0.12 + kRadius - deep, 0.1, 0}, Place::outside);
    EXPECT_NEAR(rim / floor, 1.0, 0.005);
    EXPECT_NEAR(wall / floor, 1.0, 0.03) << "it is round";
  }
}

// The largest change of the force from one place to the next, a micrometre apart.
double largest_step(Clay& clay, Vec3 from, Vec3 to, double& most) {
  ToolContact contact;
  const int steps = static_cast<int>(length(to - from) / 1e-6);
  double jump = 0.0;
  Vec3 last;
  most = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const Vec3 at = from + (1.0 * k / steps) * (to - from);
    contact.begin_tick();
    contact.step(clay, sweep_sphere(at, at, kRadius), 0, 1, kFrozen);
    const Vec3 force = contact.reaction().force;
    if (k > 0) jump = std::max(jump, length(force - last));
    most = std::max(most, length(force));
    last = force;
  }
  return jump;
}

TEST(ClosedPaths, ABallCarriedOverTheRimFindsNoStep) {
  for (const double deep : {0.001, 0.002, 0.004, 0.006}) {
    Clay clay = cylinder(0.020);
    double most = 0.0;
    const double y = kRim + kRadius - deep;
    EXPECT_LT(largest_step(clay, {0.066, y, 0}, {0.045, y, 0}, most), 0.002) << deep;
    EXPECT_LT(largest_step(clay, {0.024, y, 0}, {0.045, y, 0}, most), 0.002) << deep;
    EXPECT_GT(most, 0.05);
  }
  // Up the face and away over the rim, too.
  Clay clay = cylinder(0.020);
  double most = 0.0;
  EXPECT_LT(largest_step(clay, {0.060, kRim - 0.03, 0}, {0.060, kRim + 0.01, 0}, most), 0.002);
  EXPECT_GT(most, 0.5);
}

TEST(ClosedPaths, ABallCarriedOffASolidLumpFindsNoStepAndNothingBeyondItsEdge) {
  ClayDef def;
  def.height = def.floor_thickness = 0.1;
  for (const double deep : {0.002, 0.004}) {
    Clay clay = std::move(*Clay::create(def));
    double most = 0.0;
    const double y = 0.1 + kRadius - deep;
    EXPECT_LT(largest_step(clay, {0.0, y, 0}, {0.07, y, 0}, most), 0.002) << deep;
    EXPECT_GT(most, 0.2);
    ToolContact contact;
    for (double d = 0.0; d < 0.063; d += 1e-4)
      contact.begin_tick(),
          contact.step(clay, sweep_sphere({d, y, 0}, {d, y, 0}, kRadius), 0, 1, kFrozen);
    EXPECT_EQ(length(contact.reaction().force), 0.0) << "its edge is 55 mm from the axis";
  }
}

// A wheel that stands, clay that gives way, and a ball that comes over the rim: 1.72 N, and 0.16 in
// the next tick.
TEST(ClosedPaths, ABallThatShovesTheRimBeforeItFindsNoStepOverIt) {
  for (const double speed : {0.05, 0.3}) {
    Clay clay = cylinder(0.006);
    ToolContact contact;
    double jump = 0.0, most = 0.0;
    Vec3 last, at{0.066, kRim + kRadius - 0.004, 0};
    for (; at.x > 0.02; at.x -= 0.001 * speed) {
      const Vec3 to = at - Vec3{0.001 * speed, 0, 0};
      const ToolSweep sweep = sweep_sphere(at, to, kRadius);
      const int steps = steps_for(sweep, 0.02, contact.pressed());
      contact.begin_tick();
      for (int n = 0; n < steps; ++n) contact.step(clay, sweep, n, steps, {0.02, 1e7});
      const Vec3 force = contact.reaction().force;
      jump = std::max(jump, length(force - last));
      most = std::max(most, length(force));
      last = force;
    }
    EXPECT_LT(jump, 0.1 * most) << speed;
  }
}

}  // namespace
}  // namespace onggi::closed_paths_test
