#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"

namespace onggi::lab {

/// A number of a scene, and its range in validate().
struct SceneField {
  std::string name;  ///< "clay.wall_min", "slump.density", "flat_rib.length"
  double least = 0.0, most = 0.0;
  /// True if another field bounds it more closely than its own range.
  bool bounded = false;
  /// False if the scene lacks its effect or tool.
  std::function<bool(const SceneDef&)> there;
  std::function<double(const SceneDef&)> get;  ///< Only if it is there.
  /// Sets the number. Adds the effect and what it needs, and lets other lengths of the clay make
  /// room, so that the scene stays valid.
  std::function<void(SceneDef&, double)> set;
};

/// Every number of a scene: clay, ball, contact, wheel, guard, effects, paper and tool sizes.
/// Allocates.
std::vector<SceneField> scene_fields();

/// `def` without any effect, and without the paper's model.
SceneDef bare(SceneDef def);

/// Every effect by its index in each_effect(), with its name.
std::vector<std::string> effect_names();
/// Adds the effect at index `n` with its defaults, and what it needs. Does nothing on a paper
/// scene.
void add_effect(SceneDef& def, std::size_t n);
/// Removes it, and what needs it.
void remove_effect(SceneDef& def, std::size_t n);
bool has_effect(const SceneDef& def, std::size_t n);

}  // namespace onggi::lab
