#include "kiosk/lab/measure/scene_presets.h"

#include <algorithm>
#include <filesystem>

#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/ground/files/paths.h"

namespace onggi::measure {

Result<std::vector<ScenePreset>> read_presets() {
  const auto root = files::program_root();
  if (!root) return tl::unexpected(root.error());
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(*root / "config/scenes"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::ranges::sort(files);
  std::vector<ScenePreset> all;
  for (const auto& file : files) {
    settings::SceneRead read = settings::read_scene(file);
    if (!read.problems.empty()) return tl::unexpected(read.problems.front());
    all.push_back({file.stem().string(), std::move(read.def)});
  }
  return all;
}

}  // namespace onggi::measure
