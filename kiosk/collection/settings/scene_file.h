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
  /// quality = "auto": the grid is to be found on the machine that the scene runs on
  /// (kiosk/exhibit/tuning); until it is, clay.rows and clay.sectors hold. Never of the printed
  /// model's scenes.
  bool auto_quality = false;
};

/// Reads a scene: tables [clay] [tool] [contact] [wheel] [guard], whose keys are SceneDef's own,
/// and the effects (engine/docs/effects.md), which are simulated where their table is written and
/// absent where it is not. Ranges are the engine's. `def` always passes validate(): what it refuses
/// goes back to its default, with a Problem. A file that cannot be read gives SceneDef's defaults.
SceneRead read_scene(const std::filesystem::path& file);

}  // namespace onggi::settings
