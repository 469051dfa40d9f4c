#include "kiosk/exhibit/composition/file_kind.h"

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

#include "engine/scene/scene_def.h"
#include "kiosk/ground/toml/toml_reader.h"
#include "kiosk/wheel/device/device_kind.h"

namespace fs = std::filesystem;

namespace onggi::exhibit {
namespace {

bool is_scene_table(const std::string& key) {
  bool found = key == "clay" || key == "tool" || key == "contact" || key == "wheel" ||
               key == "guard" || key == "paper";
  SceneDef every;
  each_effect(every, [&](auto& effect) {
    found = found || key == std::remove_reference_t<decltype(*effect)>::kName;
  });
  return found;
}

}  // namespace

FileKind kind_of_toml(const fs::path& file) {
  toml::TomlReader reader(file);
  const auto keys = reader.ok() ? reader.root().keys() : std::vector<std::string>{};
  const auto has = [&keys](const char* key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  };
  const fs::path folder = file.parent_path().filename();
  if (folder == "devices" && std::ranges::any_of(device::device_kinds(), [&](const auto& kind) {
        return kind.id == file.stem().string();
      }))
    return FileKind::device;
  if (has("page") && has("editors")) return FileKind::staff_page;
  if (has("text") && has("code")) return FileKind::language;  // it may also have [glaze.ID]
  if (file.filename() == "vessel.toml" || has("label")) return FileKind::vessel;
  if (has("outer") || has("inner")) return FileKind::drawing;
  if (has("body") && has("step")) return FileKind::decoration;
  if ((has("tool") && has("simplified")) || folder == "ways") return FileKind::way;
  if (has("glaze")) return FileKind::glazes;
  if (has("thing")) return FileKind::names;
  if (has("step")) return FileKind::lesson;
  if (has("mission")) return FileKind::missions;
  if (has("outline") || has("stars") || has("size_counts")) return FileKind::rubric;
  if (std::ranges::any_of(keys, is_scene_table)) return FileKind::scene;
  return FileKind::exhibit;
}

}  // namespace onggi::exhibit
