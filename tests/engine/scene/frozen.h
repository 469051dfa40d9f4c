#pragma once

#include <utility>

#include "engine/scene/scene.h"

namespace onggi {

// Clay that keeps its shape: it gives way in a second, a tick lasts a microsecond, and a hand goes
// a micrometre in one. So what a hand feels is a figure of its place alone, and a push that changes
// by more than its slope in a micrometre has a step there.
inline constexpr double kFrozenTick = 1e-6;

inline SceneDef frozen(double thickness) {
  SceneDef def;
  def.contact.relaxation_time = 1.0;
  def.clay.outer_radius = 0.055;
  def.clay.inner_radius = 0.055 - thickness;
  def.clay.wall_min = 0.002;
  def.clay.keep_undo = false;
  return def;
}

inline Scene scene_of(const SceneDef& def) { return std::move(*Scene::create(def)); }

// What hand `n` is pushed by, before friction, coupling and guard, N.
inline Vec3 pushed(Scene& scene, const Hands& hands, std::size_t n = 0) {
  return scene.step(hands, kFrozenTick).hand[n].touch.push;
}

// The largest change of the push on hand 0 from one tick to the next, N, as it goes from `from` to
// `to` by a micrometre a tick. Another hand stays where `hands` has it.
inline double largest_step(Scene& scene, Hands hands, Vec3 from, Vec3 to) {
  const int ticks = static_cast<int>(length(to - from) / 1e-6);
  double most = 0.0;
  Vec3 last;
  for (int n = 0; n <= ticks; ++n) {
    hands.hand[0].position = from + (1.0 * n / ticks) * (to - from);
    const Vec3 push = pushed(scene, hands);
    if (n > 0) most = std::max(most, length(push - last));
    last = push;
  }
  return most;
}

}  // namespace onggi
