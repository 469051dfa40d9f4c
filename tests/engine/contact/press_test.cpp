
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/math/hash.h"
#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "engine/math/vectors.h"
#include "tests/support/sphere.h"

namespace onggi::press_test {
namespace {

constexpr double kTau = 0.00949;
constexpr double kStiffness = 5e6;
constexpr Yielding kClay{kTau, kStiffness};
constexpr double kRadius = 0.008;

ClayDef grid(int rows = 400, int sectors = 360) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  return def;
}
Clay lump(const ClayDef& def = {}, Vectors kind = best_vectors()) {
  return std::move(*Clay::create(def, kind));
}

// A sphere's way through the clay in one step; the law holds the target where it is in the middle.
struct SphereStep {
  Vec3 from, to;
  double radius = kRadius;
  double seconds = 0.001;
  Vec3 middle() const { return 0.5 * (from + to); }
};

SphereStep still(Vec3 at, double seconds = 0.001) { return {at, at, kRadius, seconds}; }

Press press_once(Clay& clay, WallSide side, const SphereStep& step, const Yielding& yielding) {
  return press_sphere(clay, side, step.middle(), step.radius, step.seconds, yielding);
}

double depth_at(const Clay& clay, WallSide side, Vec3 at, std::int64_t& visited) {
  return find_tool_shape("sphere")->depth(clay, side, {at}, {kRadius, 0.0, 0.0}, visited);
}

// The element nearest angle 0 in the row nearest height 0.1.
double outer_there(const Clay& clay) { return double{clay.outer(clay.first_row_above(0.1))[0]}; }

// --- An independent reference: the same law in double, one element at a time, in tiny Euler steps.

struct Ray {
  double target = 0;
  double covered = 0;  // share of the element that the sphere's section covers
};

Ray ray_target(const Clay& clay, WallSide side, Vec3 at, int j, int i) {
  const ClayDef& def = clay.def();
  const double angle = (i + 0.5) * 2.0 * portable::kPi / def.sectors;
  const double dy = at.y - clay.row_height(j);
  if (std::fabs(dy) >= kRadius) return {};
  const double r2 = kRadius * kRadius - dy * dy;
  const double r = std::sqrt(r2);
  const double u = at.x * std::cos(angle) + at.z * std::sin(angle);
  const double s = std::fabs(at.z * std::cos(angle) - at.x * std::sin(angle));
  const double q = std::sqrt(std::max(r2 - s * s, 0.0));
  const double away = u - q;
  const double d2 = at.x * at.x + at.z * at.z;
  // An element is as wide as the sector is where the section's tangents touch.
  const double width = std::sqrt(d2 - r2) * 2.0 * portable::kPi / def.sectors;
  const double covered =
      std::clamp((r + 0.5 * width - s) / width, 0.0, std::min(1.0, 2.0 * r / width));
  const double share = u <= 0.0 ? 0.0 : covered;
  if (side == WallSide::outside) return {std::max(away, def.radius_min + def.wall_min), share};
  return {std::min(u + q, def.radius_max - def.wall_min), share};
}

struct Reference {
  double face = 0;
  double mean_press = 0;
};

Reference reference(const Clay& clay, WallSide side, const SphereStep& step, int j, int i) {
  const double sign = side == WallSide::outside ? 1.0 : -1.0;
  const auto n = static_cast<std::size_t>(i);
  const double start =
      side == WallSide::outside ? double{clay.outer(j)[n]} : double{clay.inner(j)[n]};
  const Ray ray = ray_target(clay, side, step.middle(), j, i);
  Reference out{start, 0.0};
  constexpr int kParts = 2000;
  for (int part = 0; part < kParts && ray.covered > 0.0; ++part) {
    const double l = sign * (out.face - ray.target);
    if (l <= 0.0) continue;
    out.face -= sign * l * step.seconds / kTau / kParts;
    out.mean_press += l / kParts;
  }
  // In part covered, it gives way and is felt in part.
  out.face = start + ray.covered * (out.face - start);
  out.mean_press *= ray.covered;
  return out;
}

TEST(Press, AgreesWithTheSameLawInDoubleStepByTinyStep) {
  Random random(20);
  for (int round = 0; round < 40; ++round) {
    const WallSide side = round % 2 == 0 ? WallSide::outside : WallSide::inside;
    ClayDef def = grid(100, round % 3 == 0 ? 90 : 360);
    Clay clay = lump(def);
    const double d =
        side == WallSide::outside ? random.uniform(0.055, 0.064) : random.uniform(0.013, 0.022);
    const double angle = random.uniform(0.0, 6.28);
    const Vec3 from{d * std::cos(angle), random.uniform(0.05, 0.15), d * std::sin(angle)};
    const auto little = [&] { return random.uniform(-6e-4, 6e-4); };
    const Vec3 to = from + Vec3{little(), little(), little()};
    const SphereStep step{from, to, kRadius, random.uniform(0.0002, 0.005)};

    const Clay before = clay;
    const Press press = press_once(clay, side, step, kClay);
    double normal = 0.0;
    for (int j = clay.floor_rows(); j < clay.rows(); ++j) {
      if (std::fabs(clay.row_height(j) - from.y) > 0.01) continue;
      for (int i = 0; i < clay.sectors(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        const Reference expected = reference(before, side, step, j, i);
        const bool out = side == WallSide::outside;
        const double got = double{out ? clay.outer(j)[n] : clay.inner(j)[n]};
        const double old = double{out ? before.outer(j)[n] : before.inner(j)[n]};
        ASSERT_NEAR(got, expected.face, 1e-7 + 1e-3 * std::fabs(expected.face - old))
            << round << " row " << j << " sector " << i;
        const double mean = 0.5 * (old + expected.face);  // of both ends: see press_lanes.h
        const double area = mean * 2.0 * portable::kPi / def.sectors * def.height / def.rows;
        normal += kStiffness * area * expected.mean_press;
      }
    }
    EXPECT_NEAR(press.normal, normal, 1e-3 * normal + 1e-5) << round;
  }
}

// --- Corrections 10 to 12: exact relaxation.

TEST(Relaxation, AHeldPressDecaysAsAMaxwellElementAtAnyTickLength) {
  for (double dt : {0.00025, 0.001, 0.005}) {
    Clay clay = lump();
    const Vec3 at{0.062, clay.row_height(clay.first_row_above(0.1)), 0.0};
    // The first ray is half a sector off the tool's angle.
    const double half = portable::kPi / 360;
    const double target =
        at.x * std::cos(half) - std::sqrt(kRadius * kRadius - std::pow(at.x * std::sin(half), 2));
    const double l0 = 0.055 - target;
    const int ticks = static_cast<int>(0.02 / dt + 0.5);
    for (int n = 0; n < ticks; ++n) press_once(clay, WallSide::outside, still(at, dt), kClay);
    EXPECT_NEAR(outer_there(clay), target + l0 * std::exp(-0.02 / kTau), 3e-8) << dt;
  }
}

TEST(Relaxation, ATargetThatMovesEvenlyIsFollowedExactly) {
  Clay clay = lump();
  const int row = clay.first_row_above(0.1);
  const double h = clay.row_height(row);
  const double v = -0.02;  // m/s, inwards
  const double half = portable::kPi / 360;
  const auto target = [&](double x) {
    return x * std::cos(half) - std::sqrt(kRadius * kRadius - std::pow(x * std::sin(half), 2));
  };
  // Begin exactly in touch, so that the closed form holds from the start: l(0) = 0.
  double x = 0.0629;
  for (int n = 0; n < 60; ++n) x -= (target(x) - 0.055) / 1.0;
  for (int n = 0; n < 30; ++n) {
    const SphereStep step{
        {x + n * v * 0.001, h, 0}, {x + (n + 1) * v * 0.001, h, 0}, kRadius, 0.001};
    press_once(clay, WallSide::outside, step, kClay);
  }
  const double end = target(x + 30 * v * 0.001);
  const double lag = -v * kTau * (1.0 - std::exp(-0.03 / kTau));
  EXPECT_NEAR(outer_there(clay) - end, lag, 0.002 * lag);
}

TEST(Relaxation, TheForceIsTheMeanOverTheStepSoItDoesNotDependOnTheTick) {
  double impulse[2] = {0, 0};
  for (int which : {0, 1}) {
    Clay clay = lump();
    const double dt = which == 0 ? 0.005 : 0.00025;
    for (int n = 0; n < static_cast<int>(0.02 / dt + 0.5); ++n)
      impulse[which] +=
          dt * press_once(clay, WallSide::outside, still({0.062, 0.1, 0}, dt), kClay).force.x;
  }
  // How the face leans is that of the step's begin: 0.25 % in a tick of half the clay's time.
  EXPECT_NEAR(impulse[0] / impulse[1], 1.0, 0.003);
}

TEST(Relaxation, AHeldToolComesToRestBitForBit) {
  Clay clay = lump();
  for (int n = 0; n < 1000; ++n) press_once(clay, WallSide::outside, still({0.062, 0.1, 0}), kClay);
  const std::uint64_t settled = clay.hash();
  const Press rest = press_once(clay, WallSide::outside, still({0.062, 0.1, 0}), kClay);
  EXPECT_EQ(rest.touched, 0);
  EXPECT_EQ(rest.normal, 0.0);
  EXPECT_EQ(clay.hash(), settled);
}

// --- Correction 13: what is felt does not depend on the grid.

TEST(Force, ConvergesAsTheGridIsRefinedWherePlainSumsGrowEightfold) {
  // The paper's own four grids.
  const ClayDef grids[] = {grid(200, 180), grid(200, 360), grid(400, 360), grid(800, 360)};
  double area_weighted[4];
  double plain_sum[4];
  for (int n = 0; n < 4; ++n) {
    Clay clay = lump(grids[n]);
    const Press press = press_once(clay, WallSide::outside, still({0.062, 0.1003, 0.001}), kClay);
    area_weighted[n] = press.force.x;
    plain_sum[n] = press.normal / (0.055 * 0.2 / grids[n].rows / grids[n].sectors);
  }
  for (double f : area_weighted) EXPECT_NEAR(f / area_weighted[3], 1.0, 0.03);
  EXPECT_NEAR(plain_sum[3] / plain_sum[0], 8.0, 0.4);
}

TEST(Force, PointsFromTheTouchedWallToTheToolOnBothFaces) {
  Clay clay = lump();
  const Press out = press_once(clay, WallSide::outside, still({0.0, 0.1, 0.062}), kClay);
  EXPECT_GT(out.force.z, 0.0);
  EXPECT_NEAR(out.force.x / out.force.z, 0.0, 0.02);
  EXPECT_NEAR(out.force.y / out.force.z, 0.0, 0.02);
  const Press in = press_once(clay, WallSide::inside, still({-0.015, 0.1, 0.0}), kClay);
  EXPECT_GT(in.force.x, 0.0);  // pushed back to the axis
  EXPECT_GE(in.normal, length(in.force));
}

TEST(Force, DoesNotJumpWhereTheToolsCentreCrossesTheSurface) {
  // Correction 6. R = 50 mm, H_r = 8 mm: as printed, the law changes at a press of 8 mm, and the
  // radial force falls 26 times between 7.9 and 8.1 mm.
  ClayDef def;
  def.outer_radius = 0.05;
  double last = 0.0;
  for (double depth = 0.0070; depth < 0.0090; depth += 0.0001) {
    Clay clay = lump(def);
    const double force =
        press_once(clay, WallSide::outside, still({0.058 - depth, 0.1, 0.0}), kClay).force.x;
    if (last > 0.0) {
      EXPECT_NEAR(force / last, 1.0, 0.05) << depth;
    }
    last = force;
  }
}

// --- Shape.

TEST(Shape, AfterALongPressTheLensOfSphereAndCylinderIsGone) {
  ClayDef def = grid(1600, 1440);
  Clay clay = lump(def);
  const double before = clay.volume();
  const Vec3 at{0.060, 0.1, 0.0};
  for (int n = 0; n < 300; ++n) press_once(clay, WallSide::outside, still(at), kClay);
  // Independent: count the points of a fine mesh in both bodies.
  const double h = 1e-4;
  long inside = 0;
  for (double x = 0.052; x < 0.055; x += h)
    for (double y = -0.008; y < 0.008; y += h)
      for (double z = -0.008; z < 0.008; z += h) {
        const double px = x + h / 2, py = y + h / 2, pz = z + h / 2;
        const double dx = px - at.x;
        inside +=
            px * px + pz * pz < 0.055 * 0.055 && dx * dx + py * py + pz * pz < kRadius * kRadius;
      }
  const double lens = static_cast<double>(inside) * h * h * h;
  EXPECT_NEAR((before - clay.volume()) / lens, 1.0, 0.01);
}

TEST(Shape, ATargetBeyondTheAxisIsSignedAndStopsAtTheThinnestCore) {
  // Correction 4: E1 beyond the axis has a negative radius, and its norm would be taken for a far
  // wall: |u - q| = 6 mm here, where the sphere covers everything from -6 mm out.
  Clay clay = lump();
  const Vec3 at{0.002, 0.1, 0.0};
  for (int n = 0; n < 2000; ++n) press_once(clay, WallSide::outside, still(at), kClay);
  const int row = clay.first_row_above(0.1);
  EXPECT_NEAR(clay.outer(row)[0], 0.006, 1e-6);  // radius_min + wall_min
  EXPECT_NEAR(clay.inner(row)[0], 0.002, 1e-6);
}

TEST(Shape, PressingThinCarriesTheOtherFaceAlongAtTheThinnestWall) {
  Clay clay = lump();
  const int row = clay.first_row_above(0.1);
  for (int n = 0; n < 400; ++n) press_once(clay, WallSide::outside, still({0.0285, 0.1, 0}), kClay);
  EXPECT_NEAR(clay.outer(row)[0], 0.0205, 4e-5);
  EXPECT_NEAR(clay.outer(row)[0] - clay.inner(row)[0], 0.004, 1e-8);

  Clay other = lump();
  for (int n = 0; n < 400; ++n) press_once(other, WallSide::inside, still({0.060, 0.1, 0}), kClay);
  EXPECT_NEAR(other.inner(row)[0], 0.068, 4e-5);
  EXPECT_NEAR(other.outer(row)[0] - other.inner(row)[0], 0.004, 1e-8);
  for (int n = 0; n < 400; ++n) press_once(other, WallSide::inside, still({0.3, 0.1, 0}), kClay);
  EXPECT_LE(other.outer(row)[0], 0.16f);
}

TEST(Shape, TheSolidFloorIsCutFromOutsideAndNeverPushedFromInside) {
  Clay clay = lump();
  for (int n = 0; n < 300; ++n)
    press_once(clay, WallSide::outside, still({0.058, 0.002, 0}), kClay);
  EXPECT_LT(clay.outer(0)[0], 0.051f);
  EXPECT_EQ(clay.inner(0)[0], 0.0f);
  Clay whole = lump();
  press_once(whole, WallSide::inside, still({0.05, 0.0, 0}), kClay);
  for (int j = 0; j < whole.floor_rows(); ++j) EXPECT_EQ(whole.outer(j)[0], 0.055f);
}

RC_GTEST_PROP(PressProperty, LeavesTheClayWithinItsLimitsWhateverTheToolDoes, ()) {
  ClayDef def = grid(24, 40);
  Clay clay = lump(def);
  for (int n = 0; n < 60; ++n) {
    const auto metres = [] { return *rc::gen::inRange(-2000, 2001) * 1e-4; };
    const WallSide side = *rc::gen::element(WallSide::outside, WallSide::inside);
    const Vec3 from{metres(), metres(), metres()};
    const double radius = *rc::gen::inRange(10, 501) * 1e-4;
    const Vec3 to = from + Vec3{0.1 * radius, -0.1 * radius, 0.05 * radius};
    const Press p =
        press_once(clay, side, {from, to, radius, *rc::gen::inRange(1, 5001) * 1e-6}, kClay);
    RC_ASSERT(is_finite(p.force));
    RC_ASSERT(p.normal >= 0.0);
    RC_ASSERT(length(p.force) <= p.normal * 1.0001 + 1e-9);
  }
  const float rounding = 3e-8f;
  for (int j = 0; j < clay.rows(); ++j) {
    for (std::size_t i = 0; i < 40; ++i) {
      const float out = clay.outer(j)[i];
      const float in = clay.inner(j)[i];
      RC_ASSERT(in >= (j < clay.floor_rows() ? 0.0f : 0.002f - rounding));
      RC_ASSERT(out >= in + 0.004f - rounding);
      RC_ASSERT(out <= 0.16f + rounding);
      RC_ASSERT(j >= clay.floor_rows() || in == 0.0f);
    }
  }
}

// --- Speed must not change what comes out.

TEST(Press, HasTheSameBitsWhereverOneLooks) {
  // Rows whose extent is not known are looked at whole, others only where they can be touched.
  Random random(7);
  Clay narrow = lump(grid(60, 100));
  Clay wide = narrow;
  for (int n = 0; n < 400; ++n) {
    const WallSide side = random.uniform(0.0, 1.0) < 0.5 ? WallSide::outside : WallSide::inside;
    const double d = random.uniform(0.0, 0.064);
    const double angle = random.uniform(0.0, 6.28);
    const Vec3 at{d * std::cos(angle), random.uniform(0.0, 0.2), d * std::sin(angle)};
    for (int j = 0; j < wide.rows(); ++j) wide.widen_extent(j, 1.0f, 0.0f);
    const Press a = press_once(narrow, side, still(at), kClay);
    const Press b = press_once(wide, side, still(at), kClay);
    EXPECT_EQ(a.force, b.force);
    EXPECT_EQ(a.touched, b.touched);
    EXPECT_LE(a.visited, b.visited);
  }
  EXPECT_EQ(narrow.hash(), wide.hash());
}

TEST(Press, HasTheSameBitsOnEveryKindOfVector) {
  std::vector<std::uint64_t> hashes;
  for (const Vectors kind : vectors_here()) {
    Random random(8);
    Clay clay = lump(grid(60, 100), kind);
    StateHash hash;
    for (int n = 0; n < 300; ++n) {
      const WallSide side = n % 2 == 0 ? WallSide::outside : WallSide::inside;
      const Vec3 at{random.uniform(-0.064, 0.064), random.uniform(0.0, 0.2),
                    random.uniform(-0.064, 0.064)};
      const Press press = press_once(clay, side, still(at), kClay);
      for (double v : {press.force.x, press.force.y, press.force.z, press.normal, press.depth})
        hash.add(v);
      hash.add(static_cast<std::uint64_t>(press.visited));
    }
    hash.add(clay.hash());
    hashes.push_back(hash.value());
  }
  EXPECT_GE(hashes.size(), 1u);
  for (std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
}

TEST(Depth, IsTheDeepestElementAndChangesNothing) {
  const Clay clay = lump();
  const std::uint64_t before = clay.hash();
  std::int64_t visited = 0;
  const double h = clay.row_height(200);
  EXPECT_NEAR(depth_at(clay, WallSide::outside, {0.0625, h, 0}, visited), 0.0005, 3e-5);
  EXPECT_EQ(depth_at(clay, WallSide::outside, {0.0631, h, 0}, visited), 0.0);
  EXPECT_NEAR(depth_at(clay, WallSide::inside, {0.0145, h, 0}, visited), 0.0005, 3e-5);
  EXPECT_GT(visited, 0);
  EXPECT_EQ(clay.hash(), before);
}

}  // namespace
}  // namespace onggi::press_test
