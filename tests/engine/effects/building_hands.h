#pragma once

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/scene/scene.h"
#include "tests/engine/effects/random_hands.h"

namespace onggi::effects_test {

/// A disc to build on: 10 mm high, 45 mm wide round the axis, and nothing laid.
inline SceneDef bench(int rows = 12, int sectors = 64) {
  SceneDef def;
  def.clay.rows = rows;
  def.clay.sectors = sectors;
  def.clay.height = def.clay.floor_thickness = 0.010;
  def.clay.outer_radius = 0.045;
  def.clay.wall_min = 0.003;
  def.wheel.acceleration = 1000.0;
  def.volume.emplace();
  def.building.emplace().drift = 0.0;
  return def;
}

/// How high the coil's middle is held so that it rests on the rim.
inline double resting(const Scene& scene) {
  return scene.clay().rim_height() + 0.499 * scene.def().building->coil;
}

/// A hand goes round with a coil, `radius` (m) from the axis, by so many `turns` in `seconds`, on a
/// wheel that stands. Negative turns: the other way.
inline void go_round(Scene& scene, double radius, double turns = 1.0, double seconds = 2.0,
                     double tick = 0.001, double from = 0.0) {
  Hands hands;
  const int ticks = static_cast<int>(seconds / tick + 0.5);
  const double height = resting(scene);
  for (int n = 0; n <= ticks; ++n) {
    const double angle = from + turns * 2.0 * portable::kPi * n / ticks;
    hands.hand[0] = {{radius * portable::cos(angle), height, radius * portable::sin(angle)}, true};
    hands.hand[0].coil = true;
    scene.step(hands, tick);
  }
}

/// Nobody touches anything, for `seconds`.
inline void wait(Scene& scene, double seconds, Hands hands = {}) {
  for (int n = 0; n < static_cast<int>(1000 * seconds + 0.5); ++n) {
    scene.step(hands, 0.001);
    hands.restore = hands.renew = false;
  }
}
inline void undo(Scene& scene) {
  Hands hands;
  hands.restore = true;
  wait(scene, 0.5, hands);
}

/// Sectors on which half a ring lies.
inline int laid_sectors(const Scene& scene) {
  return static_cast<int>(
      std::ranges::count_if(scene.coil().centre, [](float centre) { return centre > 0; }));
}

/// A ring of the coil's section whose middle is `radius` from the axis, m^3 (Pappus).
inline double ring(const SceneDef& def, double radius) {
  const double coil = def.building->coil;
  return 0.25 * portable::kPi * coil * coil * 2.0 * portable::kPi * radius;
}

}  // namespace onggi::effects_test
