#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/lab/closed_form.h"
#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"

// Written from the parts on walls and slump of engine/docs/effects.md.
namespace onggi::lab {
namespace {

constexpr double kGravity = 9.81;
constexpr double kThumbRadius = 0.008;
constexpr double kWallTick = 0.001;

double girth_of(const Clay& clay, int row) {
  double sum = 0.0;
  for (std::size_t i = 0; i < clay.outer(row).size(); ++i) {
    const double outer = double{clay.outer(row)[i]}, inner = double{clay.inner(row)[i]};
    sum += 0.5 * (outer * outer + inner * inner);
  }
  return std::sqrt(sum / clay.sectors());
}

double middle_of(const Clay& clay, int row) {
  double sum = 0.0;
  for (std::size_t i = 0; i < clay.outer(row).size(); ++i)
    sum += 0.5 * (double{clay.outer(row)[i]} + double{clay.inner(row)[i]});
  return sum / clay.sectors();
}

double thinnest_of(const Clay& clay, int row) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < clay.outer(row).size(); ++i)
    least = std::min(least, double{clay.outer(row)[i]} - double{clay.inner(row)[i]});
  return least;
}

// Steps until a row tears, `most` ticks at the most, with `hands(n)` in tick n. The first torn row,
// or -1.
template <class HandsAt>
int torn_row(Scene& scene, int most, HandsAt&& hands) {
  for (int n = 0; n < most; ++n) {
    if (!scene.step(hands(n), kWallTick).torn) continue;
    for (int j = 0; j < scene.clay().rows(); ++j)
      if (scene.torn(j)) return j;
  }
  return -1;
}

// A finger inside opens a pot by 1 mm/s till it tears.
double opened_too_far(double by) {
  SceneDef def = lone_wall(100, 96, 0.045, 0.055);
  def.clay.height = 0.1;
  def.walls.emplace().tear_strain = (1.0 + by) * 0.2;
  Scene scene = scene_of(def);
  const double girth = girth_of(scene.clay(), 60);
  Hands hands = ball_at({}, SideWish::inside);
  hands.wheel_speed = 18.0;
  const int row = torn_row(scene, 15'000, [&](int n) {
    hands.hand[0].position = {0.045 - kThumbRadius + 1e-6 * n, 0.06, 0};
    return hands;
  });
  if (row < 0) return HUGE_VAL;
  double widest = 0.0;
  for (int j = row; j < scene.clay().rows(); ++j)
    if (scene.torn(j)) widest = std::max(widest, girth_of(scene.clay(), j));
  return share_apart(widest / girth - 1.0, 0.2);
}

// Two hands close by 0.2 mm/s on a wall of 4 mm.
double pressed_too_thin(double by) {
  SceneDef def = lone_wall(100, 96, 0.051, 0.055);
  def.clay.height = 0.1;
  def.clay.wall_min = 0.001;
  def.walls.emplace().tear_thickness = (1.0 + by) * 0.003;
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = 18.0;
  hands.hand[1] = hands.hand[0];
  hands.hand[1].side = SideWish::inside;
  const int row = torn_row(scene, 12'000, [&](int n) {
    const double way = 0.002 - 1e-7 * n + kThumbRadius;
    hands.hand[0].position = {0.053 + way, 0.06, 0};
    hands.hand[1].position = {0.053 - way, 0.06, 0};
    return hands;
  });
  if (row < 0) return HUGE_VAL;
  double least = HUGE_VAL;
  for (int j = row; j < scene.clay().rows(); ++j)
    if (scene.torn(j)) least = std::min(least, thinnest_of(scene.clay(), j));
  return share_apart(least, 0.003);
}

// A finger outside takes the wall 8 mm inwards: its ring keeps its area.
double collared(double by) {
  SceneDef def = lone_wall(100, 96, 0.045, 0.055);
  def.clay.height = 0.1;
  def.walls.emplace();
  const double area = portable::kPi * (0.055 * 0.055 - 0.045 * 0.045);
  def.clay.outer_radius *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands = ball_at({}, SideWish::outside);
  hands.wheel_speed = 18.0;
  for (int n = 0; n < 3000; ++n) {
    hands.hand[0].position = {0.055 + kThumbRadius - 4e-6 * std::min(n, 2000), 0.06, 0};
    scene.step(hands, kWallTick);
  }
  return share_apart(row_area_of(scene.clay(), 60), area);
}

// N / sqrt(1 + (N / P)^2) of a wall of 4 mm, P = pi sigma t^2.
double a_wall_that_bends(double by) {
  SceneDef def = lone_wall(200, 180, 0.051, 0.055);
  def.clay.wall_min = 0.002;
  def.contact.relaxation_time = 1.0;
  const Vec3 at{0.055 + kThumbRadius - 0.002, 0.1, 0};
  const auto felt = [&](double strength) {
    def.walls.emplace().bending_strength = strength;
    Scene scene = scene_of(def);
    return length(scene.step(ball_at(at, SideWish::outside), 1e-6).hand[0].touch.push);
  };
  const double normal = fresh_press(*Clay::create(def.clay), WallSide::outside, at, kThumbRadius,
                                    def.contact.stiffness)
                            .normal;
  const double bears = portable::kPi * 14'700.0 * 0.004 * 0.004;
  return share_apart(felt(14'700.0 * (1.0 + by)) / felt(0.0),
                     1.0 / std::sqrt(1.0 + normal / bears * normal / bears));
}

SceneDef slumping(const ClayDef& clay) {
  SceneDef def = lone_lump(clay.rows, clay.sectors);
  def.clay = clay;
  def.volume.emplace();
  def.slump.emplace();
  return def;
}

ClayDef tube(int rows, double height, double inner, double outer) {
  ClayDef clay = lone_wall(rows, 16, inner, outer).clay;
  clay.height = height;
  clay.floor_thickness = 0.0;
  return clay;
}

// The largest yield stress (Pa, shear) at which the pot flows, by halves; about `near`.
double yields_from(SceneDef def, double near, const Hands& hands, double seconds) {
  def.slump->viscosity = 10.0;
  double flows = 0.8 * near, stands = 1.25 * near;
  for (int n = 0; n < 22; ++n) {
    def.slump->yield_stress = 0.5 * (flows + stands);
    Scene scene = scene_of(def);
    const std::uint64_t before = scene.clay().hash();
    for (long k = std::lround(seconds / 0.005); k > 0; --k) scene.step(hands, 0.005);
    (scene.clay().hash() == before ? stands : flows) = def.slump->yield_stress;
  }
  return 0.5 * (flows + stands);
}

// The lowest row bears all that lies over its middle.
double weight_on_the_foot(const SceneDef& def) {
  return def.slump->density * kGravity * def.clay.height * (1.0 - 0.5 / def.clay.rows);
}

double under_its_weight(double by) {
  SceneDef def = slumping(tube(60, 0.25, 0.045, 0.055));
  const double should = weight_on_the_foot(def) / std::sqrt(3.0);
  def.slump->density *= 1.0 + by;
  return share_apart(yields_from(def, should, {}, 0.5), should);
}

double soaked_under_its_weight(double by) {
  SceneDef def = slumping(tube(60, 0.25, 0.045, 0.055));
  const MoistureDef law =
      def.moisture.emplace(MoistureDef{.wetting_time = 0.05, .weakening = 0.1, .air = 1.0});
  const double should = weight_on_the_foot(def) / std::sqrt(3.0) / law.weakening;  // w = 1
  def.moisture->weakening *= 1.0 + by;
  Hands hands;
  hands.water = true;
  return share_apart(yields_from(def, should, hands, 1.5), should);
}

// Of clay that turns, over density omega^2: the pull of half of it, summed up ring by ring, over
// the cut that bears it.
double pull_across(double inner, double outer) {
  constexpr int kRings = 1000;
  const double wide = (outer - inner) / kRings;
  double sum = 0.0;
  for (int n = 0; n < kRings; ++n) {
    const double r = inner + (n + 0.5) * wide;
    sum += r * r * wide;
  }
  return sum / (outer - inner);
}

double spun_ring(double by) {
  SceneDef def = slumping(tube(20, 0.05, 0.045, 0.055));
  Hands hands;
  hands.wheel_speed = 20.0;
  const double hoop = def.slump->density * 20.0 * 20.0 * pull_across(0.045, 0.055);
  const double should = (hoop + weight_on_the_foot(def)) / std::sqrt(3.0);
  def.slump->density *= 1.0 + by;
  return share_apart(yields_from(def, should, hands, 0.5), should);
}

double spun_lump(double by) {
  SceneDef def = slumping(tube(20, 0.05, 0.045, 0.055));
  def.clay.floor_thickness = def.clay.height;
  Hands hands;
  hands.wheel_speed = 20.0;
  const double pull = def.slump->density * 20.0 * 20.0 * pull_across(0.0, 0.055);
  const double should = (pull + weight_on_the_foot(def)) / std::sqrt(3.0);
  def.slump->density *= 1.0 + by;
  return share_apart(yields_from(def, should, hands, 0.5), should);
}

// How much wider the middle row of a ring gets that is spun too fast: Levy and Mises, Heun's rule.
double spun_wider(double by) {
  SceneDef def = slumping(tube(20, 0.02, 0.045, 0.055));
  def.slump->yield_stress = 2000.0;
  def.slump->viscosity = 1e5;
  const SlumpDef law = *def.slump;
  def.slump->viscosity *= 1.0 + by;
  Scene scene = scene_of(def);
  Hands hands;
  const double wheel = 30.0, seconds = 20.0;
  hands.wheel_speed = wheel;
  const int row = 10;
  const double middle_was = middle_of(scene.clay(), row), area = row_area_of(scene.clay(), row);
  const double above = 0.02 - scene.clay().row_height(row);  // m of clay of its own
  for (long n = std::lround(seconds / 0.005); n > 0; --n) scene.step(hands, 0.005);
  struct Grown {
    double girth = 0.0, area = 0.0;  // as logarithms
  };
  const auto rate = [&](Grown g) {
    const double middle = 0.05 * portable::exp(g.girth);
    const double thick = 0.01 * portable::exp(g.area - g.girth);
    const double hoop =
        law.density * wheel * wheel * pull_across(middle - 0.5 * thick, middle + 0.5 * thick);
    const double weight = law.density * kGravity * above * portable::exp(-g.area);
    const double flow =
        std::max(hoop + weight - std::sqrt(3.0) * law.yield_stress, 0.0) / (3.0 * law.viscosity);
    return Grown{flow * (2.0 * hoop + weight) / (2.0 * (hoop + weight)),
                 flow * (2.0 * weight + hoop) / (2.0 * (hoop + weight))};
  };
  constexpr double kPart = 5e-3;
  Grown grown;
  for (double t = wheel / 1000.0; t < seconds; t += kPart) {
    const Grown a = rate(grown);
    const Grown b = rate({grown.girth + kPart * a.girth, grown.area + kPart * a.area});
    grown.girth += 0.5 * kPart * (a.girth + b.girth);
    grown.area += 0.5 * kPart * (a.area + b.area);
  }
  return std::max(
      share_apart(portable::log(middle_of(scene.clay(), row) / middle_was), grown.girth),
      share_apart(portable::log(row_area_of(scene.clay(), row) / area), grown.area));
}

// A tube of which `stands` of its height can stand.
SceneDef sagging(double stands, double viscosity) {
  SceneDef def = slumping(tube(200, 0.25, 0.045, 0.055));
  def.slump->viscosity = viscosity;
  def.slump->yield_stress =
      stands * def.slump->density * kGravity * def.clay.height / std::sqrt(3.0);
  return def;
}

double sags_at_first(double by) {
  SceneDef def = sagging(0.5, 1e4);
  const SlumpDef law = *def.slump;
  def.slump->yield_stress *= 1.0 + by;
  Scene scene = scene_of(def);
  constexpr double kSeconds = 3.0;
  for (long n = std::lround(kSeconds / kWallTick); n > 0; --n) scene.step({}, kWallTick);
  double should = 0.0;
  constexpr int kHeightsOf = 1000;
  for (int n = 0; n < kHeightsOf; ++n) {
    const double weight = law.density * kGravity * 0.25 * (n + 0.5) / kHeightsOf;
    const double left = closed_form::sagging_stress(weight, std::sqrt(3.0) * law.yield_stress,
                                                    law.viscosity, kSeconds);
    should += 0.25 / kHeightsOf * (1.0 - left / weight);
  }
  return share_apart(0.25 - scene.clay().rim_height(), should);
}

double sags_to_its_end(double by) {
  SceneDef def = sagging(0.7, 100.0);
  def.slump->yield_stress *= 1.0 + by;
  Scene scene = scene_of(def);
  for (int n = 0; n < 20'000; ++n) scene.step({}, 0.005);
  return share_apart(0.25 - scene.clay().rim_height(),
                     closed_form::sagged_end(0.0, 0.25, 0.7 * 0.25));
}

constexpr Witness kWalls[] = {
    {"a wall that bends", "N / sqrt(1 + (N/P)^2), P = pi sigma t^2, N added up in doubles",
     "walls.bending_strength", 1e-5, "", a_wall_that_bends},
    {"a wall alone, collared", "its ring keeps pi (R^2 - r^2)", "clay.outer_radius", 1e-6, "",
     collared},
    {"opened till it tears", "girth: the root of (R^2 + r^2) / 2, from the radii",
     "walls.tear_strain", 5e-3, "", opened_too_far},
    {"pressed till it tears", "the thinnest place, from the radii", "walls.tear_thickness", 2e-3,
     "", pressed_too_thin},
    {"where a tube yields", "rho g (H - dh/2) = sqrt3 tau_y", "slump.density", 1e-5, "",
     under_its_weight},
    {"where a soaked tube yields", "rho g (H - dh/2) = sqrt3 tau_y weakening^w, to 0.01 of w",
     "moisture.weakening", 0.025, "", soaked_under_its_weight},
    {"where a ring that spins yields",
     "rho g (H - dh/2) + the mean pull across a cut = sqrt3 tau_y", "slump.density", 1e-5, "",
     spun_ring},
    {"where a lump that spins yields", "the same, without a hole", "slump.density", 1e-5, "",
     spun_lump},
    {"a ring that spins, wider and lower", "Levy and Mises, solved by hand", "slump.viscosity",
     0.01, "", spun_wider},
    {"how a tube sags", "Bingham's law of each height, in closed form", "slump.yield_stress", 2e-3,
     "", sags_at_first},
    {"where a tube that sags comes to rest", "H - H_c (1 + ln H/H_c)", "slump.yield_stress", 1e-3,
     "", sags_to_its_end},
};

}  // namespace

std::span<const Witness> wall_witnesses() { return kWalls; }

}  // namespace onggi::lab
