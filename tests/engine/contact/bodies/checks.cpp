#include "tests/engine/contact/bodies/checks.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "engine/math/random.h"
#include "engine/math/unit.h"
#include "engine/math/vectors.h"
#include "tests/support/any_direction.h"

namespace onggi::body_checks {

using test::any_direction;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr Yielding kClay{0.00949, 5e6};
constexpr double kSeconds = 0.001;
constexpr double kWallRadius = 0.055;

Clay lump(int rows, int sectors, Vectors kind = best_vectors()) {
  ClayDef def;
  def.rows = rows;
  def.sectors = sectors;
  return std::move(*Clay::create(def, kind));
}

// Moves the tool, level, until its farthest point `towards` the axis or away from it is `away` from
// the axis.
void put_in(const ToolShape& shape, const ToolSize& size, ToolPlace& place, Vec3 towards,
            double away) {
  const body::Ball ball = shape.support(place, size, towards);
  const Vec3 farthest = ball.middle + ball.radius * towards;
  // A wall is pressed from outside towards the axis.
  Vec3 shift = (away > 0.04 ? -away : away) * towards - farthest;
  shift.y = 0.0;
  place.at += shift;
}

// A random pose whose deepest point is some way in the wall, on one side or the other.
ToolPlace random_pose(Random& random, const ToolShape& shape, const ToolSize& size, WallSide side) {
  const Vec3 along = any_direction(random);
  const Vec3 across = unit(cross(along, any_direction(random)));
  const double angle = random.uniform(0.0, 2.0 * kPi);
  const Vec3 out{std::cos(angle), 0.0, std::sin(angle)};
  ToolPlace place{{0.0, random.uniform(0.06, 0.14), 0.0}, along, across};
  const Vec3 towards = side == WallSide::outside ? -out : out;
  const double deep = random.uniform(0.0003, 0.003);
  put_in(shape, size, place, towards,
         side == WallSide::outside ? kWallRadius - deep : 0.022 + deep);
  return place;
}

// Where the ray (at height y, angle phi) enters and leaves the body.
struct Chord {
  double near, far;
};
std::optional<Chord> march(const Distance& distance, const ToolPlace& place, const ToolSize& size,
                           double y, double phi) {
  const Vec3 way{std::cos(phi), 0.0, std::sin(phi)};
  const auto at = [&](double t) { return distance(t * way + Vec3{0.0, y, 0.0}, place, size); };
  // Sphere tracing: a step as long as the distance cannot pass the surface.
  const auto trace = [&](double t, double sign, double end) -> std::optional<double> {
    while (sign * (end - t) > 0.0) {
      const double d = at(t);
      if (d < 1e-9) return t;
      t += sign * std::max(d, 2e-9);
    }
    return {};
  };
  const auto near = trace(-0.3, 1.0, 0.3);
  if (!near) return {};
  const auto far = trace(0.3, -1.0, -0.3);
  return Chord{*near, far.value_or(*near)};
}

Vec3 outer_normal(const Distance& distance, const ToolPlace& place, const ToolSize& size, Vec3 p) {
  constexpr double kStep = 1e-6;
  const auto slope = [&](Vec3 step) {
    return distance(p + step, place, size) - distance(p - step, place, size);
  };
  return unit({slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})});
}

const ToolShape& shape_of(std::string_view name) { return *find_tool_shape(name); }

std::span<const float> face(const Clay& clay, WallSide side, int j) {
  return side == WallSide::outside ? clay.outer(j) : clay.inner(j);
}

}  // namespace

ToolPlace pressing(const ToolShape& shape, const ToolSize& size, double outer, double deep,
                   double y, double angle) {
  const Vec3 out{std::cos(angle), 0.0, std::sin(angle)};
  ToolPlace place = hold_tool(shape, out + Vec3{0.0, y, 0.0}, {}, 0.0, false);
  put_in(shape, size, place, -out, outer - deep);
  return place;
}

// What a fingertip feels of an element's k_A l A: p of engine/docs/contact.md, on the tool's own
// surface, which has `out` for a normal. `deep`: l over the radius.
double on_its_own_surface(double deep, Vec3 out, double phi) {
  const double x = std::min(deep, 1.0);
  const double facing = std::fabs(out.x * std::cos(phi) + out.z * std::sin(phi));
  return (std::exp(x) - 1.0 - x * x) / x / std::max(facing, 0.25);
}

void agrees_with_a_ray_march(std::string_view name, const Distance& distance) {
  const ToolShape& shape = shape_of(name);
  const double gone = 1.0 - std::exp(-kSeconds / kClay.relaxation_time);
  const double mean = kClay.relaxation_time / kSeconds * gone;
  Random random(7);
  for (int round = 0; round < 24; ++round) {
    SCOPED_TRACE(std::string(name) + ", pose " + std::to_string(round));
    const WallSide side = round % 3 == 2 ? WallSide::inside : WallSide::outside;
    const ToolSize size = shape.usual;
    Clay clay = lump(200, 360);
    const ToolPlace place = random_pose(random, shape, size, side);
    const Clay before = clay;
    const Press press = shape.press(clay, side, place, size, kSeconds, kClay);
    Vec3 force;
    double normal = 0.0;
    const bool leans = shape.body == BodyKind::capsule && size.radius >= 0.002;
    double edges = 0.0;  // what elements that are covered in part may add or leave out
    const double turn = 2.0 * kPi / clay.sectors();
    for (int j = clay.floor_rows(); j < clay.rows(); ++j) {
      const double y = clay.row_height(j);
      const double half = 0.5 * clay.row_thickness(j);
      for (int i = 0; i < clay.sectors(); ++i) {
        const auto n = static_cast<std::size_t>(i);
        const double old = double{face(before, side, j)[n]};
        const double now = double{face(clay, side, j)[n]};
        const double phi = (i + 0.5) * turn;
        const double sign = side == WallSide::outside ? 1.0 : -1.0;
        int corners = 0;  // a little beyond its own: an element's width is a row's, not its own
        double deepest = 0.0;
        const auto press_on = [&](double h, double angle) {
          const auto chord = march(distance, place, size, h, angle);
          if (!chord || (side == WallSide::outside && chord->near + chord->far <= 0.0)) return -1.0;
          return sign * (old - (side == WallSide::outside ? chord->near : chord->far));
        };
        // Far from the tool nothing need be marched.
        const double off = place.at.z * std::cos(phi) - place.at.x * std::sin(phi);
        const double bound = shape.reach(size) + 0.002;
        if (std::fabs(off) > bound || std::fabs(y - place.at.y) > bound) {
          ASSERT_EQ(now, old) << j << ' ' << i;
          continue;
        }
        for (double h : {y - 1.3 * half, y + 1.3 * half})
          for (double angle : {phi - 0.8 * turn, phi + 0.8 * turn}) {
            const double l = press_on(h, angle);
            corners += l > -1.0 ? 1 : 0;
            deepest = std::max(deepest, l);
          }
        const double middle = press_on(y, phi);
        deepest = std::max(deepest, middle);
        // As the press fades the face goes by as much, so their product's mean is that of both
        // ends.
        const double area = 0.5 * (old + now) * turn * 2.0 * half;
        if (corners < 4) {
          // Covered in part: it gives way by no more than if it were covered whole.
          constexpr int kParts = 16;
          const double most = sign * (old - now) - 3e-5;
          for (int k = 0; k < kParts * kParts && most > gone * deepest; ++k)
            deepest =
                std::max(deepest, press_on(y + ((k / kParts + 0.5) * 2.0 / kParts - 1.0) * half,
                                           phi + ((k % kParts + 0.5) / kParts - 0.5) * turn));
          ASSERT_LE(most, gone * deepest) << j << ' ' << i;
          ASSERT_GE(sign * (old - now), 0.0) << j << ' ' << i;
          edges += kClay.stiffness * area * mean * sign * (old - now) / gone;
          continue;
        }
        const double expected = old - sign * gone * std::max(middle, 0.0);
        ASSERT_NEAR(now, expected, 3e-6 + 0.002 * std::fabs(expected - old)) << j << ' ' << i;
        if (middle <= 0.0) continue;
        const Vec3 end =
            (old - sign * middle) * Vec3{std::cos(phi), 0.0, std::sin(phi)} + Vec3{0.0, y, 0.0};
        const double part = kClay.stiffness * area * mean * middle;
        normal += part;
        // Next to one that is not pressed the sum is mended by less than half of it.
        if (press_on(y, phi - turn) <= 0.0 || press_on(y, phi + turn) <= 0.0) edges += 0.5 * part;
        const Vec3 out = outer_normal(distance, place, size, end);
        force += -(leans ? part * on_its_own_surface(middle / size.radius, out, phi) : part) * out;
      }
    }
    EXPECT_GT(press.touched, 0);
    EXPECT_NEAR(press.normal, normal, 1.02 * edges + 0.005 * normal + 1e-4);
    EXPECT_LT(length(press.force - force), 1.02 * edges + 0.02 * normal + 1e-4);
    EXPECT_LE(length(press.force), press.normal * (1.0 + 1e-6));
  }
}

void same_bits_on_all_vectors(std::string_view name) {
  const ToolShape& shape = shape_of(name);
  std::vector<std::uint64_t> hashes;
  std::vector<Vec3> forces;
  for (const Vectors kind : vectors_here()) {
    Random random(11);
    Clay clay = lump(120, 200, kind);
    Vec3 sum;
    for (int n = 0; n < 60; ++n) {
      const WallSide side = n % 2 == 0 ? WallSide::outside : WallSide::inside;
      const ToolPlace place = random_pose(random, shape, shape.usual, side);
      sum += shape.press(clay, side, place, shape.usual, kSeconds, kClay).force;
    }
    hashes.push_back(clay.hash());
    forces.push_back(sum);
    EXPECT_EQ(hashes.front(), hashes.back()) << name_of(kind);
    EXPECT_EQ(forces.front(), forces.back()) << name_of(kind);
  }
}

void symmetric_pose_leaves_symmetric_mark(std::string_view name) {
  const ToolShape& shape = shape_of(name);
  Clay clay = lump(400, 360);
  const ToolPlace place = pressing(shape, shape.usual, kWallRadius, 0.001, 0.1, 0.0);
  Press press;
  for (int n = 0; n < 20; ++n)
    press = shape.press(clay, WallSide::outside, place, shape.usual, kSeconds, kClay);
  EXPECT_GT(press.touched, 0);
  EXPECT_NEAR(press.force.z, 0.0, 1e-4 * press.normal);
  float deepest = 0.0f;
  for (int j = 0; j < clay.rows(); ++j)
    for (std::size_t i = 0; i < 180; ++i) {
      ASSERT_NEAR(clay.outer(j)[i], clay.outer(j)[359 - i], 1e-7) << j << ' ' << i;
      deepest = std::max(deepest, 0.055f - clay.outer(j)[i]);
    }
  EXPECT_GT(deepest, 0.0005f);
}

void random_poses_stay_within_limits(std::string_view name) {
  const ToolShape& shape = shape_of(name);
  EXPECT_TRUE(rc::check(std::string(name) + " in any pose", [&] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    Clay clay = lump(24 + static_cast<int>(random.bits() % 40), 40);
    for (int n = 0; n < 12; ++n) {
      const auto between = [&](double low, double high) {
        return low > 0.0 ? random.uniform(low, high) : 0.0;
      };
      const ToolSize size{between(shape.least.radius, shape.most.radius),
                          between(shape.least.length, shape.most.length),
                          between(shape.least.thickness, shape.most.thickness)};
      Vec3 along = any_direction(random);
      Vec3 across = unit(cross(along, any_direction(random)));
      if (n % 4 == 0) along = {0, 1, 0}, across = {0, 0, 1};
      if (n % 4 == 1) along = {1, 0, 0}, across = {0, 1, 0};
      const ToolPlace place{
          {random.uniform(-0.2, 0.2), random.uniform(-0.1, 0.3), random.uniform(-0.2, 0.2)},
          along,
          across};
      const WallSide side = n % 2 == 0 ? WallSide::outside : WallSide::inside;
      std::int64_t visited = 0;
      const double depth = shape.depth(clay, side, place, size, visited);
      const Press press = shape.press(clay, side, place, size, random.uniform(1e-5, 5e-3), kClay);
      RC_ASSERT(std::isfinite(depth) && depth >= 0.0 && depth < 1.0);
      RC_ASSERT((depth > 0.0) == (press.touched > 0));
      RC_ASSERT(is_finite(press.force) && std::isfinite(press.normal));
      RC_ASSERT(length(press.force) <= press.normal * (1.0 + 1e-6) + 1e-9);
      RC_ASSERT(press.visited >= press.touched);
      RC_ASSERT(press.visited <= 40 * clay.rows());
    }
    const ClayDef& def = clay.def();
    for (int j = 0; j < clay.rows(); ++j)
      for (std::size_t i = 0; i < 40; ++i) {
        const double outer = double{clay.outer(j)[i]};
        const double inner = double{clay.inner(j)[i]};
        RC_ASSERT(outer <= def.radius_max + 3e-8 && inner >= 0.0);
        RC_ASSERT(outer - inner >= def.wall_min - 3e-8);
        if (j >= clay.floor_rows()) RC_ASSERT(inner >= def.radius_min - 3e-8);
      }
  }));
}

void ball_reaches_as_far_as_the_body(std::string_view name, const Distance& distance) {
  const ToolShape& shape = shape_of(name);
  Random random(3);
  for (int n = 0; n < 60; ++n) {
    const Vec3 along = any_direction(random);
    const ToolPlace place{{0.01, 0.02, 0.03}, along, unit(cross(along, any_direction(random)))};
    const Vec3 towards = any_direction(random);
    const body::Ball ball = shape.support(place, shape.usual, towards);
    const double reach = dot(ball.middle, towards) + ball.radius;
    EXPECT_LE(length(ball.middle - place.at), shape.reach(shape.usual) + ball.radius);
    double farthest = -1.0;
    const double bound = shape.reach(shape.usual);
    // From far out that way, down to the body: the farthest of random places, and of places ever
    // nearer to the farthest.
    Vec3 best = place.at;
    double spread = bound;
    for (int k = 0; k < 1500; ++k) {
      const Vec3 aside = cross(towards, any_direction(random));
      const Vec3 foot =
          best - dot(best - place.at, towards) * towards + random.uniform(0.0, spread) * aside;
      double t = 1.5 * bound;
      double d = 1.0;
      for (int step = 0; step < 300 && t > -1.5 * bound; ++step) {
        d = distance(foot + t * towards, place, shape.usual);
        if (d < 1e-7) break;
        t -= d;
      }
      if (d >= 1e-7) continue;
      const Vec3 p = foot + t * towards;
      if (dot(p, towards) > farthest) {
        farthest = dot(p, towards);
        best = p;
      }
      spread = std::max(0.997 * spread, 0.002 * bound);
    }
    EXPECT_LE(farthest, reach + 1e-6) << n;
    EXPECT_GE(farthest, reach - 0.02 * bound) << n;
  }
}

void looks_where_it_touches(std::string_view name) {
  const ToolShape& shape = shape_of(name);
  for (double roll : {0.0, 0.8, 1.5707963267948966}) {
    Clay clay = lump(1600, 1440);
    ToolPlace place = pressing(shape, shape.usual, kWallRadius, 0.0, 0.1, 0.4);
    const Vec3 out = unit({place.at.x, 0.0, place.at.z});
    place = hold_tool(shape, place.at, {}, roll, false);
    put_in(shape, shape.usual, place, -out, kWallRadius - 0.001);
    const Press press = shape.press(clay, WallSide::outside, place, shape.usual, kSeconds, kClay);
    EXPECT_GT(press.touched, 0) << roll;
    EXPECT_LE(press.visited, 10 * press.touched) << roll;
  }
}

void force_does_not_depend_on_the_grid(std::string_view name, double share) {
  const ToolShape& shape = shape_of(name);
  double felt[4];
  const int rows[] = {100, 200, 400, 800};
  const int sectors[] = {180, 360, 360, 720};
  for (int n = 0; n < 4; ++n) {
    Clay clay = lump(rows[n], sectors[n]);
    const ToolPlace place = pressing(shape, shape.usual, kWallRadius, 0.001, 0.1003, 0.013);
    felt[n] =
        length(shape.press(clay, WallSide::outside, place, shape.usual, kSeconds, kClay).force);
  }
  for (double f : felt) EXPECT_NEAR(f / felt[3], 1.0, share);
}

void force_is_even(std::string_view name, double share) {
  const ToolShape& shape = shape_of(name);
  // With elements to spare beyond a block of eight, and with none.
  for (const int sectors : {360, 353})
    for (const double deep : {0.0015, 0.006}) {
      double least = 1e9;
      double most = 0.0;
      for (int n = 0; n < 48; ++n) {
        Clay clay = lump(400, sectors);
        // Thirds of an element, over the seam between the last and the first.
        const double angle = (n / 3.0 - 8.0) * 2.0 * kPi / sectors;
        const ToolPlace place = pressing(shape, shape.usual, kWallRadius, deep, 0.1003, angle);
        const double felt =
            shape.press(clay, WallSide::outside, place, shape.usual, kSeconds, kClay).normal;
        least = std::min(least, felt);
        most = std::max(most, felt);
      }
      EXPECT_LT(most / least - 1.0, share) << sectors << " sectors, " << deep << " m";
    }
}

}  // namespace onggi::body_checks
