#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"

namespace onggi::lab {

/// A number of a scene, and the ends of its range as validate() has them.
struct SceneField {
  std::string name;  ///< "clay.wall_min", "slump.density", "flat_rib.length"
  double least = 0.0, most = 0.0;
  /// Another field bounds it as well, more closely than its own range.
  bool bounded = false;
  /// False where the scene has no such number: its effect or its tool is not there.
  std::function<bool(const SceneDef&)> there;
  std::function<double(const SceneDef&)> get;  ///< Only where it is there.
  /// Puts the effect there where need be, with what it needs, and lets other lengths of the clay
  /// make room, so that the scene is one again.
  std::function<void(SceneDef&, double)> set;
};

/// Every number of a scene: clay, ball, contact, wheel, guard, effects, paper and the sizes of the
/// tools to hand. Allocates.
std::vector<SceneField> scene_fields();

/// `def` without any effect, and without the paper's model.
SceneDef bare(SceneDef def);

/// Every effect by its place in each_effect(), with its name.
std::vector<std::string> effect_names();
/// Puts the effect at place `n` there as it is by default, and what it needs; on a paper's scene
/// nothing is put.
void add_effect(SceneDef& def, std::size_t n);
/// Takes it away, and what needs it.
void remove_effect(SceneDef& def, std::size_t n);
bool has_effect(const SceneDef& def, std::size_t n);

}  // namespace onggi::lab
