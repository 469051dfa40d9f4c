#include <cmath>
#include <vector>

#include "engine/lab/built_accuracy.h"
#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"

// Written from the parts on building and beating of engine/docs/effects.md.
namespace onggi::lab {
namespace {

constexpr double kCoil = 0.012, kCoilMiddle = 0.04, kDisc = 0.010;  // m
constexpr double kBeatenOut = 0.055, kBeatenIn = 0.047;
constexpr double kEnergy = 0.03, kStress = 60e3, kPaddle = 0.02;

// A hand goes once round a disc, 10 mm high, with a coil.
struct Coiled {
  Scene scene;
  double before;  // m^3, without the ring
};
Coiled coiled(double by) {
  SceneDef def = lone_lump(12, 90);
  def.clay.height = def.clay.floor_thickness = kDisc;
  def.clay.outer_radius = 0.05;
  def.volume.emplace();
  def.building.emplace().coil = (1.0 + by) * kCoil;
  def.building->drift = 0.0;
  Scene scene = scene_of(def);
  const double before = volume_of(scene.clay());
  Hands hands;
  for (int n = 0; n <= 4000; ++n) {
    const double angle = 2.0 * portable::kPi * n / 2000.0;
    const double up = scene.clay().rim_height() + 0.499 * def.building->coil;
    hands.hand[0].position = {kCoilMiddle * portable::cos(angle), up,
                              kCoilMiddle * portable::sin(angle)};
    hands.hand[0].active = hands.hand[0].coil = n <= 2000;
    scene.step(hands, 0.001);
  }
  return {std::move(scene), before};
}

// Its section along a circle.
double a_ring_of_coil(double by) {
  const Coiled ring = coiled(by);
  const double section = 0.25 * portable::kPi * kCoil * kCoil;
  return share_apart(volume_of(ring.scene.clay()) - ring.before,
                     section * 2.0 * portable::kPi * kCoilMiddle);
}

// A circle's mean chord between -0.8 and 0.8 of its radius: by hand 0.8797 of its diameter.
double a_ring_pressed_flat(double by) {
  const Coiled ring = coiled(by);
  const double chord = 0.5 * (0.6 + portable::asin(0.8) / 0.8) * kCoil;
  return share_apart(ring.scene.clay().rim_height() - kDisc,
                     0.25 * portable::kPi * kCoil * kCoil / chord);
}

double never() { return 0.0; }

// A builder's work with one number of the scene altered, against the second program, which
// believes what stands there. m, root mean square over both faces.
double off_second_program(const BuiltScript& believed, const BuiltScript& altered) {
  AccuracySetting setting;
  setting.rows = 200;
  setting.sectors = 180;
  return measure_built(altered, truth_of(believed, 1000, 940), setting, never).errors.shape_rms;
}

double a_ring_that_wanders(double by) {
  const BuiltScript believed = built_scripts().front();
  BuiltScript altered = believed;
  altered.work.def.building->coil *= 1.0 + by;
  return off_second_program(believed, altered);
}

double eight_blows(double by) {
  const BuiltScript believed = built_scripts().back();
  BuiltScript altered = believed;
  altered.work.def.beating->yield_stress *= 1.0 + by;
  return off_second_program(believed, altered);
}

// What a blow did to a wall of 8 mm: the walls before and after, in place.
struct Beaten {
  std::vector<double> before, after, areas;  // m, m, m^2 of each element's outer face
  double outer = 0.0;                        // m, in the middle of the blow, afterwards
  double across = 0.0;                       // m, the same on the other side of the ring
};
Beaten beaten(const BeatingDef& law, bool anvil) {
  SceneDef def = lone_wall(120, 240, kBeatenIn, kBeatenOut);
  def.clay.height = 0.12;
  def.clay.wall_min = 0.001;
  def.volume.emplace();
  def.beating = law;
  Scene scene = scene_of(def);
  Beaten all;
  const auto walls = [&](std::vector<double>& into) {
    for (int j = scene.clay().floor_rows(); j < scene.clay().rows(); ++j)
      for (std::size_t i = 0; i < 240; ++i)
        into.push_back(double{scene.clay().outer(j)[i]} - double{scene.clay().inner(j)[i]});
  };
  walls(all.before);
  all.areas.assign(all.before.size(),
                   kBeatenOut * 2.0 * portable::kPi / 240 * scene.clay().first_thickness());
  Hands hands;
  const int row = scene.clay().first_row_above(0.06);
  hands.hand[0].position = on_first_ray(scene.clay(), row, kBeatenOut + 0.012);
  hands.hand[0].active = true;
  hands.hand[0].paddle = true;
  hands.hand[0].anvil = anvil ? 1.0 : 0.0;
  for (const bool blow : {false, true}) {
    hands.hand[0].blow = blow;
    scene.step(hands, 0.001);
  }
  walls(all.after);
  all.outer = double{scene.clay().outer(row)[0]};
  all.across = double{scene.clay().outer(row)[120]};
  return all;
}

double pressure_on(double stress, double thick) {
  return stress * (1.0 + 2.0 * kPaddle / (3.0 * std::sqrt(3.0) * thick));
}

double a_blow_on_an_anvil(double by) {
  const Beaten wall = beaten({kEnergy, kPaddle, (1.0 + by) * kStress}, true);
  const double pressure = pressure_on(kStress, kBeatenOut - kBeatenIn);
  double work = 0.0;
  for (std::size_t n = 0; n < wall.before.size(); ++n)
    work += pressure * wall.areas[n] * wall.before[n] * std::log(wall.before[n] / wall.after[n]);
  return share_apart(work, kEnergy);
}

// Half of the mean ln(t / t') goes round. E / (p t) is the sum of ln(t / t') over the face; of the
// face's weight a third of its area lies on all rings, and 16/15 of its radius on the middle one.
double a_blow_that_widens(double by) {
  const Beaten wall = beaten({kEnergy, kPaddle, (1.0 + by) * kStress}, true);
  const double thick = kBeatenOut - kBeatenIn, middle = 0.5 * (kBeatenOut + kBeatenIn);
  const double squeezed = kEnergy / (pressure_on(kStress, thick) * thick);
  const double on_middle = 16.0 / 15.0 * kPaddle / (2.0 * portable::kPi * kBeatenOut);
  const double on_all = portable::kPi * kPaddle * kPaddle / 3.0;
  return share_apart(wall.across - kBeatenOut, 0.5 * middle * on_middle * squeezed / on_all);
}

double a_blow_without_an_anvil(double by) {
  const Beaten wall = beaten({kEnergy, kPaddle, (1.0 + by) * kStress}, false);
  const double thick = kBeatenOut - kBeatenIn;
  return share_apart(portable::kPi * kStress * thick * thick * (kBeatenOut - wall.outer), kEnergy);
}

constexpr Witness kBuildingWitnesses[] = {
    {"a ring of coil", "Pappus: its section times the way of its middle", "building.coil", 1e-4, "",
     a_ring_of_coil},
    {"a ring pressed flat", "its height: pi coil^2 / 4 by the mean chord, 0.893 coils",
     "building.coil", 2e-3, "", a_ring_pressed_flat},
    {"a ring that wanders", "a second program: where the hand went, the last gap closed evenly",
     "building.coil", 1e-4, "m", a_ring_that_wanders},
    {"a blow on an anvil", "its energy: Y ln(t / t') over the clay, under rough faces",
     "beating.yield_stress", 5e-3, "", a_blow_on_an_anvil},
    {"a blow without an anvil", "its energy: pi Y t^2 times the dent", "beating.yield_stress", 5e-3,
     "", a_blow_without_an_anvil},
    {"a blow that widens the ring", "half of E / (p t) over the face, by hand",
     "beating.yield_stress", 2e-3, "", a_blow_that_widens},
    {"eight blows on a wall that turns", "a second program in doubles: plane, depth, round and up",
     "beating.yield_stress", 2e-6, "m", eight_blows},
};

}  // namespace

std::span<const Witness> building_witnesses() { return kBuildingWitnesses; }

}  // namespace onggi::lab
