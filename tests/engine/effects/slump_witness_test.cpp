#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/lab/closed_form.h"
#include "tests/engine/effects/random_hands.h"
#include "tests/engine/effects/witnessed.h"

namespace onggi::effects::slump_witness_test {
namespace {

using namespace effects_test;
namespace closed_form = lab::closed_form;

// Written from the equations in engine/docs/effects.md alone. A height z under the rim of a
// straight tube bears density g z and flows until it bears no more than sqrt(3) tau_y; its area
// grows, its height falls by the same factor.

constexpr double kGravity = 9.81;

struct Pot {
  std::string name;
  double height = 0.25, outer = 0.055, inner = 0.045, floor = 0.0;
};
const Pot kThin{"a tube of 45 to 55 mm"};
const Pot kThick{"a tube of 22 to 55 mm", 0.25, 0.055, 0.022, 0.0};
const Pot kLump{"the default lump", 0.20, 0.055, 0.022, 0.010};
const Pot kWide{"a tube of 69 to 75 mm", 0.18, 0.075, 0.069, 0.0};

struct Grid {
  int rows = 400;
  double tick = 0.005;
};

// The highest stress is `height`'s own over `critical` of it: of a pot with a floor, of its wall.
SceneDef scene_of(const Pot& pot, double critical, double viscosity, int rows) {
  SceneDef def;
  def.clay.rows = rows;
  def.clay.sectors = 16;
  def.clay.height = pot.height;
  def.clay.outer_radius = pot.outer;
  def.clay.inner_radius = pot.inner;
  def.clay.floor_thickness = pot.floor;
  def.volume.emplace();
  def.slump.emplace();
  def.slump->viscosity = viscosity;
  def.slump->yield_stress =
      critical * def.slump->density * kGravity * (pot.height - pot.floor) / std::sqrt(3.0);
  return def;
}

double yield_of(const SceneDef& def) { return std::sqrt(3.0) * def.slump->yield_stress; }

// The end of the wall, and of the floor: there the wall weighs as much as a shorter one of its
// area.
double closed_end(const Pot& pot, double critical) {
  const double wall = pot.height - pot.floor;
  const double stands = critical * wall;
  const double hole = pot.inner / pot.outer;
  const double on_floor = wall * (1.0 - hole * hole);
  return closed_form::sagged_end(0.0, wall, stands) +
         closed_form::sagged_end(on_floor, on_floor + pot.floor, stands);
}

// Runs until the rim sinks by less than 2 um/s, or nothing yields; `most` seconds at the most.
void settle(Scene& scene, double tick, double most) {
  for (double t = 0.0; t < most;) {
    const double before = scene.clay().rim_height();
    for (int n = 0; n < std::lround(5.0 / tick); ++n) scene.step({}, tick);
    t += 5.0;
    if (before - scene.clay().rim_height() < 1e-8) return;
  }
}

struct End {
  double sunk = 0.0;   // of the pot's height, m
  double light = 0.0;  // by how much less than it could the least loaded row bears that flowed
  double heavy = 0.0;  // and by how much more than it could the most loaded one
  double wider = 0.0;  // by how much a row that never had to flow is larger
};

End end_of(const Pot& pot, double critical, double viscosity, const Grid& grid, double seconds) {
  const SceneDef def = scene_of(pot, critical, viscosity, grid.rows);
  Scene scene = made(def);
  const Clay& clay = scene.clay();
  const double area = clay.measured_area(clay.rows() - 1);
  settle(scene, grid.tick, seconds);
  End end;
  end.sunk = pot.height - clay.rim_height();
  double above = 0.0;
  for (int j = clay.rows() - 1; j >= clay.floor_rows(); --j) {
    const double now = clay.measured_area(j);
    const double own = now * clay.row_thickness(j);
    const double load = def.slump->density * kGravity * (above + 0.5 * own);
    above += own;
    const double bears = load / now / yield_of(def);
    end.heavy = std::max(end.heavy, bears - 1.0);
    if (load / area > yield_of(def))
      end.light = std::max(end.light, 1.0 - bears);
    else
      end.wider = std::max(end.wider, now / area - 1.0);
  }
  return end;
}

void expect_closed_end(const Pot& pot, double critical, double viscosity, const Grid& grid,
                       double seconds) {
  const End end = end_of(pot, critical, viscosity, grid, seconds);
  const std::string where = pot.name + ", " + std::to_string(critical) + " of critical, " +
                            std::to_string(viscosity) + " Pa s, " + std::to_string(grid.rows) +
                            " rows, " + std::to_string(grid.tick) + " s";
  const double closed = closed_end(pot, critical);
  witnessed("sagged, end", "H - H_c (1 + ln H/H_c): " + where, std::fabs(end.sunk / closed - 1.0),
            0.005);
  witnessed("sagged, what a row that flowed bears less than it could", where, end.light, 1e-4);
  witnessed("sagged, what a row bears more than it could", where, end.heavy, 0.01);
  witnessed("sagged, what a row that stood is larger", where, end.wider, 1e-5);
}

TEST(SlumpWitness, APotThatSagsComesToRestAtTheClosedEndAndEachRowBearsWhatItCan) {
  for (const Pot& pot : {kThin, kThick, kLump, kWide})
    for (const double critical : {0.3, 0.7, 0.9})
      expect_closed_end(pot, critical, 100.0, {}, 100.0);
}

TEST(SlumpWitness, TheEndIsTheSameOnAnyGridAtAnyTickAndHoweverSlowlyClayFlows) {
  for (const double critical : {0.3, 0.9}) {
    for (const Grid& grid : {Grid{60, 0.001}, Grid{600, 0.005}, Grid{100, 0.0007}})
      expect_closed_end(kThin, critical, 1000.0, grid, 200.0);
    expect_closed_end(kThick, critical, 1e4, {}, 1000.0);
  }
}

// The course: every height by itself.
double sinks_by_law(const Pot& pot, const SceneDef& def, double seconds) {
  constexpr int kRows = 500;
  const double each = pot.height / kRows;
  const double hole = pot.inner / pot.outer;
  double sum = 0.0;
  for (int j = 0; j < kRows; ++j) {
    double bears = each * (j + 0.5);  // of its own clay
    if (bears > pot.height - pot.floor) bears -= (pot.height - pot.floor) * hole * hole;
    const double weight = def.slump->density * kGravity * bears;
    sum += each * (1.0 - closed_form::sagging_stress(weight, yield_of(def), def.slump->viscosity,
                                                     seconds) /
                             weight);
  }
  return sum;
}

TEST(SlumpWitness, APotSagsAsFastAsTheLawOfEachHeightSays) {
  for (const Pot& pot : {kThin, kThick, kLump})
    for (const double critical : {0.3, 0.7, 0.9})
      for (const double seconds : {0.5, 2.0, 10.0, 30.0}) {
        const SceneDef def = scene_of(pot, critical, 1e4, 400);
        Scene scene = made(def);
        for (int n = 0; n < std::lround(seconds / 0.001); ++n) scene.step({}, 0.001);
        const double law = sinks_by_law(pot, def, seconds);
        witnessed("sagged, course",
                  "every height by itself: " + pot.name + ", " + std::to_string(critical) +
                      " of critical, after " + std::to_string(seconds) + " s",
                  std::fabs((pot.height - scene.clay().rim_height()) / law - 1.0), 0.02);
      }
}

// A lump that is solid but for a rim of a few rows.
SceneDef solid_lump() {
  SceneDef def;
  def.clay.rows = 100;
  def.clay.sectors = 48;
  def.clay.height = 0.1;
  def.clay.outer_radius = 0.07;
  def.clay.inner_radius = 0.06;
  def.clay.floor_thickness = 0.095;
  def.wheel.acceleration = 1000.0;
  def.volume.emplace();
  def.slump.emplace();
  def.slump->yield_stress = 1460.0;
  def.slump->viscosity = 1e5;
  return def;
}

// Half a disc of density rho that turns: each element is pulled outwards, and the cut through the
// axis bears the sum, over its width.
double pull_of(const SceneDef& def, double omega, double area) {
  const double edge = std::sqrt(area / 3.14159265358979);
  constexpr int kRings = 2000;
  double sum = 0.0;
  for (int n = 0; n < kRings; ++n) {
    const double r = (n + 0.5) * edge / kRings;
    sum += r * r / kRings;
  }
  return def.slump->density * omega * omega * sum;
}

double load_on(const SceneDef& def, const Clay& clay, int row) {
  double above = 0.0;
  for (int j = clay.rows() - 1; j > row; --j)
    above += clay.measured_area(j) * clay.row_thickness(j);
  return def.slump->density * kGravity *
         (above + 0.5 * clay.measured_area(row) * clay.row_thickness(row));
}

TEST(SlumpWitness, ASolidLumpSpreadsFromTheSpeedAtWhichItsMiddleYields) {
  const SceneDef def = solid_lump();
  Scene lump = made(def);
  const double area = lump.clay().measured_area(0);
  const double rest = yield_of(def) - load_on(def, lump.clay(), 0) / area;
  const double critical = std::sqrt(rest / pull_of(def, 1.0, area));
  for (const double part : {0.995, 1.005}) {
    Scene scene = made(def);
    Hands hands;
    hands.wheel_speed = part * critical;
    for (int n = 0; n < 4000; ++n) scene.step(hands, 0.001);
    EXPECT_EQ(scene.clay().measured_area(0) > area, part > 1.0) << part;
    EXPECT_EQ(scene.clay().measured_area(90), area) << part;  // with less on it
  }
}

// One law: 30 rad/s and 40 before, with a hole of half a millimetre.
TEST(SlumpWitness, ANarrowHoleHardlyChangesHowFastALumpMayBeSpun) {
  const auto yields_at = [](double hole) {
    SceneDef def = solid_lump();
    def.clay.floor_thickness = hole > 0.0 ? 0.002 : def.clay.height;
    if (hole > 0.0) def.clay.radius_min = def.clay.inner_radius = hole;
    const Scene scene = made(def);
    const int row = 5;
    const auto yields = [&](double omega) {
      Scene spun = made(def);
      Hands hands;
      hands.wheel_speed = omega;
      for (int n = 0; n < 300; ++n) spun.step(hands, 0.005);
      return spun.clay().measured_area(row) != scene.clay().measured_area(row);
    };
    double low = 5.0, high = 31.0;
    for (int n = 0; n < 10; ++n) {
      const double middle = 0.5 * (low + high);
      (yields(middle) ? high : low) = middle;
    }
    return low;
  };
  EXPECT_NEAR(yields_at(0.0005) / yields_at(0.0), 1.0, 0.02);
}

TEST(SlumpWitness, ASolidLumpThatIsSpunTooFastBecomesWiderAndLowerAtItsRate) {
  const SceneDef def = solid_lump();
  Scene scene = made(def);
  Hands hands;
  hands.wheel_speed = 31.0;
  const double area = scene.clay().measured_area(0);
  const double volume = scene.clay().volume();
  const int row = 50;
  const double load = load_on(def, scene.clay(), row);
  constexpr double kSeconds = 8.0;
  for (int n = 0; n < std::lround(kSeconds / 0.001); ++n) scene.step(hands, 0.001);
  // A' = A (load / A + pull(A) - sqrt(3) tau_y) / 3 eta, from when the wheel has its speed. Heun.
  double a = area;
  constexpr double kStep = 1e-3;
  const auto rate = [&](double now) {
    return now * (load / now + pull_of(def, 31.0, now) - yield_of(def)) /
           (3.0 * def.slump->viscosity);
  };
  for (int n = 0; n < std::lround((kSeconds - 0.031) / kStep); ++n) {
    const double first = rate(a);
    a += 0.5 * kStep * (first + rate(a + kStep * first));
  }
  witnessed("spun, solid lump",
            "the pull of half a disc, Levy and Mises: growth of its area in 8 s",
            std::fabs((scene.clay().measured_area(row) - area) / (a - area) - 1.0), 0.02);
  EXPECT_NEAR(scene.clay().volume() / volume, 1.0, 2e-9);
}

}  // namespace
}  // namespace onggi::effects::slump_witness_test
