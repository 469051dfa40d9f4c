#include "kiosk/exhibit/scenes.h"

#include <algorithm>

#include "engine/base/nearest_name.h"
#include "engine/effects/kiln.h"
#include "engine/script/script.h"
#include "kiosk/exhibit/log.h"
#include "kiosk/settings/scene_file.h"
#include "kiosk/settings/toml_reader.h"

namespace onggi::exhibit {
namespace {

constexpr double kUsualCoat = 0.0005;  // m: a coat of 1 in the picture

SceneDef read(const std::filesystem::path& file, double force) {
  settings::SceneRead scene = settings::read_scene(file);
  log_problems(scene.problems);
  scene.def.guard.max_force *= force;
  return std::move(scene.def);
}

}  // namespace

Scenes::Scenes(const settings::Exhibit& exhibit)
    : exhibits_(read(exhibit.scene, exhibit.screen.force)),
      attract_scripts_(exhibit.attract_scripts) {
  bool fires = exhibits_.kiln.has_value();
  for (const auto& [id, file] : exhibit.vessel_scenes) {
    const auto own = vessels_.emplace(id, read(file, exhibit.screen.force)).first;
    fires = fires || own->second.kiln;
  }
  if (!fires) return;
  auto glazes = content::read_glazes(exhibit.glazes, exhibit.languages);
  log_problems(glazes.problems);
  glazes_ = std::move(glazes.glazes);
}

const SceneDef& Scenes::of(const std::string& id) const {
  const auto own = vessels_.find(id);
  return own != vessels_.end() ? own->second : exhibits_;
}

screens::Wheel Scenes::wheel_of(const std::string& id) const {
  const SceneDef& def = of(id);
  screens::Wheel wheel{def.wheel.max_speed,
                       def.tool.radius,
                       std::nullopt,
                       {},
                       def.walls ? def.walls->tear_thickness : 0.0};
  for (const std::string& script : attract_scripts_)
    if (const ScriptInfo* info = find_script(script);
        info != nullptr && (info->needs.target || shows_its_effect(*info, def)))
      wheel.shown.push_back(script);
  if (wheel.shown.empty()) wheel.shown.push_back("follow");
  if (def.kiln && !glazes_.empty())
    wheel.kiln = screens::Kiln{size_after(*def.kiln, {1.0, 0.0}), size_after(*def.kiln, {1.0, 1.0}),
                               def.kiln->glaze_thickness / kUsualCoat, &glazes_};
  return wheel;
}

settings::Problems names_of_nothing(const settings::Exhibit& exhibit,
                                    const std::vector<std::string>& ids) {
  settings::TomlReader reader(exhibit.file);
  auto root = reader.root();
  auto scenes = root.child("vessel_scenes");
  for (const auto& [id, scene] : exhibit.vessel_scenes) {
    if (std::ranges::find(ids, id) != ids.end()) continue;
    const std::string nearest = nearest_name(id, ids);
    scenes.complain(id, "There is no vessel \"" + id + "\" on the shelf.",
                    nearest.empty()
                        ? "Write the name of its folder on the shelf, or remove the line."
                        : "Did you mean " + nearest + "?");
  }
  std::vector<std::string> shown;  // "follow", and those that show an effect
  for (const ScriptInfo& script : scripts())
    if (script.needs.target || !script.shows.empty()) shown.emplace_back(script.name);
  auto attract = root.child("attract");
  for (std::size_t n = 0; n < exhibit.attract_scripts.size(); ++n) {
    const std::string& script = exhibit.attract_scripts[n];
    if (std::ranges::find(shown, script) != shown.end()) continue;
    std::string all;
    for (const std::string& name : shown) all += (all.empty() ? "" : ", ") + name;
    attract.complain_at("scripts", n, "Attract mode shows no script \"" + script + "\".",
                        "Choose of " + all + ".");
  }
  return reader.problems();
}

}  // namespace onggi::exhibit
