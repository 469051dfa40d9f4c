#pragma once

#include <filesystem>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"

namespace onggi::settings {

struct SceneRead {
  SceneDef def;
  std::vector<Problem> problems;  ///< With file, line and column, in file order.
  int keys_checked = 0;
  /// True for quality = "auto": the grid is found on the machine that runs the scene
  /// (kiosk/exhibit/tuning); clay.rows and clay.sectors hold until then. Never for scenes with the
  /// printed model.
  bool auto_quality = false;
};

/// Reads a scene: tables [clay] [tool] [contact] [wheel] [guard] with SceneDef's own keys, and the
/// effects (engine/docs/effects.md), which are simulated only if their table is written. The engine
/// sets the ranges. `def` always passes validate(): a refused field gets its default, with a
/// Problem. A file that cannot be read gives SceneDef's defaults.
SceneRead read_scene(const std::filesystem::path& file);

}  // namespace onggi::settings
