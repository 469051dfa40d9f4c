#pragma once

#include <memory>
#include <utility>

#include "engine/scene/scene.h"

namespace onggi::loop {

inline SceneDef small_scene() {
  SceneDef def;
  def.clay.rows = 80;
  def.clay.sectors = 64;
  return def;
}

inline std::unique_ptr<Scene> pot(const SceneDef& def) {
  return std::make_unique<Scene>(std::move(*Scene::create(def)));
}

/// The ball at the outer wall half-way up, `depth` metres within the lump.
inline HandInput press_at(const SceneDef& def, double depth) {
  HandInput hand;
  hand.active = true;
  hand.side = SideWish::outside;
  hand.position = {def.clay.outer_radius + def.tool.radius - depth, def.clay.height / 2, 0};
  return hand;
}

}  // namespace onggi::loop
