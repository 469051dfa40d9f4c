#include <cmath>
#include <vector>

#include "engine/lab/witness.h"
#include "engine/lab/witness_scene.h"
#include "engine/math/portable.h"

// Written from the parts on building and beating of engine/docs/effects.md.
namespace onggi::lab {
namespace {

constexpr double kCoil = 0.012, kCoilMiddle = 0.04;  // m
constexpr double kBeatenOut = 0.055, kBeatenIn = 0.047;
constexpr double kEnergy = 0.03, kStress = 60e3, kPaddle = 0.02;

// A hand goes once round a disc with a coil: its section along a circle.
double a_ring_of_coil(double by) {
  SceneDef def = lone_lump(12, 90);
  def.clay.height = def.clay.floor_thickness = 0.010;
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
  const double section = 0.25 * portable::kPi * kCoil * kCoil;
  return share_apart(volume_of(scene.clay()) - before, section * 2.0 * portable::kPi * kCoilMiddle);
}

// What a blow did to a wall of 8 mm: the walls before and after, in place.
struct Beaten {
  std::vector<double> before, after, areas;  // m, m, m^2 of each element's outer face
  double outer = 0.0;                        // m, in the middle of the blow, afterwards
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
  return all;
}

double a_blow_on_an_anvil(double by) {
  const Beaten wall = beaten({kEnergy, kPaddle, (1.0 + by) * kStress}, true);
  const double thick = kBeatenOut - kBeatenIn;
  const double pressure = kStress * (1.0 + 2.0 * kPaddle / (3.0 * std::sqrt(3.0) * thick));
  double work = 0.0;
  for (std::size_t n = 0; n < wall.before.size(); ++n)
    work += pressure * wall.areas[n] * wall.before[n] * std::log(wall.before[n] / wall.after[n]);
  return share_apart(work, kEnergy);
}

double a_blow_without_an_anvil(double by) {
  const Beaten wall = beaten({kEnergy, kPaddle, (1.0 + by) * kStress}, false);
  const double thick = kBeatenOut - kBeatenIn;
  return share_apart(portable::kPi * kStress * thick * thick * (kBeatenOut - wall.outer), kEnergy);
}

constexpr Witness kBuildingWitnesses[] = {
    {"a ring of coil", "Pappus: its section times the way of its middle", "building.coil", 1e-4, "",
     a_ring_of_coil},
    {"a blow on an anvil", "its energy: Y ln(t / t') over the clay, under rough faces",
     "beating.yield_stress", 5e-3, "", a_blow_on_an_anvil},
    {"a blow without an anvil", "its energy: pi Y t^2 times the dent", "beating.yield_stress", 5e-3,
     "", a_blow_without_an_anvil},
};

}  // namespace

std::span<const Witness> building_witnesses() { return kBuildingWitnesses; }

}  // namespace onggi::lab
