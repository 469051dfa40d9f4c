#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/contact/tool_contact.h"
#include "engine/math/random.h"
#include "engine/math/unit.h"
#include "tests/support/any_direction.h"

// A tool that touches nothing feels nothing. How far it is from the clay is worked out here, from
// the tools' measures and the pot's: nothing of the engine is asked.
namespace onggi::clear_tools_test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNet = 0.0008;  // m

// A turned pot: its section is the square-cornered one, in which the rounded one lies.
struct Pot {
  double outer, inner, height, floor;
};

double box_distance(Vec3 p, Vec3 half) {
  const Vec3 q{std::fabs(p.x) - half.x, std::fabs(p.y) - half.y, std::fabs(p.z) - half.z};
  const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
  return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

// From `p` to the tool's surface, negative within it. m
double distance(const ToolShape& shape, const ToolSize& size, const ToolPlace& place, Vec3 p) {
  const Vec3 from = p - place.at;
  const double up = dot(from, place.along);
  const double through = dot(from, place.across);
  const double wide = dot(from, cross(place.along, place.across));
  switch (shape.body) {
    case BodyKind::capsule:
      return length(from - std::clamp(up, 0.0, size.length) * place.along) - size.radius;
    case BodyKind::box:
      return box_distance({up, through, wide},
                          {0.5 * size.length, 0.5 * size.thickness, size.radius});
    case BodyKind::cylinder: {
      const double off = std::hypot(up, wide) - size.radius;
      const double deep = std::fabs(through) - 0.5 * size.thickness;
      return std::hypot(std::max(off, 0.0), std::max(deep, 0.0)) +
             std::min(std::max(off, deep), 0.0);
    }
    default:
      return length(from) - size.radius;
  }
}

// The pot's surface within `reach` of `at`, as points no farther from each other than the net.
std::vector<Vec3> surface(const Pot& pot, Vec3 at, double reach) {
  std::vector<Vec3> points;
  const auto ring = [&](double radius, double y) {
    if (std::fabs(y - at.y) > reach) return;
    const int count = static_cast<int>(2 * kPi * radius / kNet) + 1;
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * kPi * k / count;
      const Vec3 p{radius * std::cos(angle), y, radius * std::sin(angle)};
      if (length(p - at) < reach) points.push_back(p);
    }
  };
  for (double y = 0.0; y <= pot.height; y += kNet) {
    ring(pot.outer, y);
    if (y >= pot.floor) ring(pot.inner, y);
  }
  for (double r = pot.inner; r <= pot.outer; r += kNet) ring(r, pot.height);
  ring(pot.outer, pot.height);
  for (double r = 0.0; r <= pot.inner; r += kNet) ring(r, pot.floor);
  return points;
}

// Of a tool held anyhow, or as potters do.
ToolPlace pose(Random& random, const ToolShape& shape, Vec3 at, bool inside) {
  if (random.uniform() < 0.4) return hold_tool(shape, at, {}, 0.0, inside);
  const Vec3 along = random.uniform() < 0.3 ? Vec3{0, 1, 0} : test::any_direction(random);
  const Vec3 aside = cross(along, test::any_direction(random));
  return {at, along, unit(aside)};
}

TEST(ClearTools, ATouchOfNothingIsNotFeltAndDentsNothingWhateverTheToolAndItsPlace) {
  Random random(41);
  for (const ToolShape& shape : tool_shapes()) {
    if (shape.severs()) continue;
    int tried = 0;
    for (int round = 0; round < 100; ++round) {
      ClayDef def;
      def.rows = 200;
      def.sectors = 360;
      def.outer_radius = random.uniform(0.03, 0.07);
      def.inner_radius = def.outer_radius - random.uniform(0.0045, 0.02);
      const Pot pot{def.outer_radius, def.inner_radius, def.height, def.floor_thickness};
      const ToolSize size = sized(shape, {});
      // Beside a random place of its surface, as far away as it has to be to be clear.
      const double place = random.uniform();
      const bool on_rim = place<0.3, on_floor = place> 0.9, inside = random.uniform() < 0.5;
      const double face = inside ? pot.inner : pot.outer;
      const double radius = on_floor ? random.uniform(0.0, pot.inner)
                            : on_rim ? random.uniform(pot.inner, pot.outer)
                                     : face;
      // Beside the wall, it may reach above the rim, or stand there by its lower end alone.
      const double reach = shape.reach(size);
      const double y = on_floor ? pot.floor
                       : on_rim ? pot.height
                                : pot.height + random.uniform(-0.02, reach);
      const Vec3 away = on_floor || on_rim ? Vec3{0, 1, 0} : Vec3{inside ? -1.0 : 1.0, 0, 0};
      const ToolPlace held = pose(random, shape, {radius, y, 0}, inside);
      const std::vector<Vec3> near = surface(pot, held.at, 2 * reach + 0.004);
      const auto clear = [&](double by) {
        ToolPlace moved = held;
        moved.at += by * away;
        double least = 1.0;
        for (const Vec3 p : near) least = std::min(least, distance(shape, size, moved, p));
        return least;
      };
      // A sample lies within 0.57 mm of each point of the surface.
      const double wanted = 0.0006 + random.uniform(0.0, 0.002);
      double low = 0.0, high = reach + 0.003;
      if (clear(high) < wanted) continue;  // it does not fit in there
      for (int k = 0; k < 14; ++k)
        (clear(0.5 * (low + high)) < wanted ? low : high) = 0.5 * (low + high);
      Vec3 at = held.at + high * away;
      if (at.y < reach) continue;  // the wheel head

      Clay clay = std::move(*Clay::create(def));
      const std::uint64_t before = clay.hash();
      ToolSweep sweep;
      sweep.shape = &shape;
      sweep.size = size;
      sweep.from = sweep.to = at;
      sweep.along = held.along;
      sweep.across = held.across;
      sweep.seconds = 0.001;
      sweep.wish = round % 3 == 0 ? SideWish::by_position
                   : inside       ? SideWish::inside
                                  : SideWish::outside;
      ToolContact contact;
      contact.begin_tick();
      for (int n = 0; n < 4; ++n) contact.step(clay, sweep, 0, 1, {0.00949, 5e6});
      const std::string what = std::string(shape.name) + ", round " + std::to_string(round);
      EXPECT_EQ(length(contact.reaction().force), 0.0) << what;
      EXPECT_EQ(clay.hash(), before) << what;
      ++tried;
    }
    EXPECT_GT(tried, 30) << shape.name;
  }
}

TEST(ClearTools, ARibBesideTheWallIsNotFeltAsItRisesAboveTheRim) {
  ClayDef def;
  def.inner_radius = 0.05;
  const ToolShape& rib = *find_tool_shape("flat_rib");
  const ToolSize size = sized(rib, {});
  for (const double clear : {0.0002, 0.001, 0.003}) {
    Clay clay = std::move(*Clay::create(def));
    const std::uint64_t before = clay.hash();
    ToolContact contact;
    for (int n = 0; n < 800; ++n) {
      const Vec3 at{0.055 + 0.5 * size.thickness + clear, 0.17 + 1e-4 * n, 0};
      ToolSweep sweep{&rib, size, at, at + Vec3{0, 1e-4, 0}};
      sweep.along = {0, 1, 0};
      sweep.across = {1, 0, 0};
      sweep.seconds = 0.001;
      contact.begin_tick();
      contact.step(clay, sweep, 0, 1, {0.00949, 5e6});
      ASSERT_EQ(length(contact.reaction().force), 0.0) << clear << " m clear, " << at.y;
    }
    EXPECT_EQ(clay.hash(), before);
  }
}

}  // namespace
}  // namespace onggi::clear_tools_test
