#include "tests/bench/blows.h"

#include <utility>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"

namespace onggi::bench {

Times time_blows(int rows, int sectors, int blows) {
  SceneDef def;
  each_effect(def, [](auto& effect) { effect.reset(); });
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.outer_radius = 0.060;
  def.clay.inner_radius = 0.050;
  def.clay.keep_undo = false;
  def.volume.emplace();
  def.beating = BeatingDef{0.08, 0.03, 16e3};
  Scene scene = std::move(*Scene::create(def));
  Hands hands;
  HandInput& hand = hands.hand[0];
  hand.active = hand.paddle = true;
  hand.anvil = 1.0;
  std::vector<double> ns;
  for (int n = 0; n < blows; ++n) {
    const double angle = 0.7 * n, height = 0.03 + 0.14 * n / blows;
    hand.position = {0.075 * portable::cos(angle), height, 0.075 * portable::sin(angle)};
    hand.blow = false;
    for (int tick = 0; tick < 20; ++tick) scene.step(hands, kTickSeconds);
    hand.blow = true;
    ns.push_back(timed([&] { scene.step(hands, kTickSeconds); }));
  }
  return times_of(ns);
}

}  // namespace onggi::bench
