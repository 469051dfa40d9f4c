#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"

namespace onggi::measure {

/// A scene in the program's config/scenes.
struct ScenePreset {
  std::string name;  ///< Its file name without ".toml".
  SceneDef def;
};
/// All of them, by name. Problem if one is invalid.
Result<std::vector<ScenePreset>> read_presets();

}  // namespace onggi::measure
