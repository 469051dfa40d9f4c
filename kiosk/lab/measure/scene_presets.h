#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"

namespace onggi::measure {

/// A scene that lies in config/scenes of the program.
struct ScenePreset {
  std::string name;  ///< Of its file, without ".toml".
  SceneDef def;
};
/// All of them, by name. Problem where one is not as it should be.
Result<std::vector<ScenePreset>> read_presets();

}  // namespace onggi::measure
