#include "kiosk/exhibit/composition/scenes.h"

#include <algorithm>

#include "engine/base/nearest_name.h"
#include "engine/contact/tool.h"
#include "engine/effects/kiln.h"
#include "engine/scene/lump.h"
#include "engine/script/script.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/exhibit/composition/ways.h"
#include "kiosk/exhibit/tuning/grid_memory.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/ground/files/log.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::exhibit {
namespace {

constexpr double kAway = 0.5;          // m from the axis and the wheel: every tool has space there
constexpr const char* kCoil = "coil";  // in the tray
constexpr double kUsualCoat = 0.0005;  // m: a coat of 1 in the picture

// A scene with other mistakes is told of those.
bool builds_nothing(const std::filesystem::path& scene) {
  const settings::SceneRead read = settings::read_scene(scene);
  return read.problems.empty() && !read.def.building;
}

}  // namespace

Scenes::Scenes(const settings::Exhibit& exhibit) : attract_scripts_(exhibit.attract_scripts) {
  take(exhibit, exhibits_, exhibit.scene);
  bool fires = exhibits_.kiln.has_value();
  for (const auto& [id, file] : exhibit.vessel_scenes) {
    SceneDef& own = vessels_[id];
    take(exhibit, own, file);
    fires = fires || own.kiln;
  }
  if (exhibit.build && exhibit.built_scene) {
    built_ = std::make_unique<SceneDef>();
    take(exhibit, *built_, *exhibit.built_scene);
    fires = fires || built_->kiln;
  }
  if (exhibit.decorate && exhibit.ways) {
    WaysRead ways = read_ways(*exhibit.ways);
    files::log_problems(ways.problems);
    ways_ = std::move(ways.ways);
    decorates_ = true;
  }
  if (!fires) return;
  auto glazes = content::read_glazes(exhibit.glazes, exhibit.languages, exhibit.translations);
  files::log_problems(glazes.problems);
  glazes_ = std::move(glazes.glazes);
}

Scenes::~Scenes() = default;

void Scenes::take(const settings::Exhibit& exhibit, SceneDef& def,
                  const std::filesystem::path& file) {
  settings::SceneRead scene = settings::read_scene(file);
  files::log_problems(scene.problems);
  def = std::move(scene.def);
  def.guard.max_force *= exhibit.screen.force;
  if (scene.auto_quality) to_tune_.push_back({&def, file, {}});
}

void Scenes::tune(const std::filesystem::path& folder, const tuning::TunePlan& plan) {
  if (to_tune_.empty()) return;
  plan_ = plan;
  machine_ = tuning::machine_name();
  std::erase_if(to_tune_, [&](ToTune& scene) {
    const auto memory = tuning::memory_of(folder, scene.file, machine_);
    if (!memory) return files::log_problem(memory.error()), true;
    scene.memory = *memory;
    const auto grid = tuning::remembered(*memory);
    if (!grid) return false;
    scene.def->clay.rows = grid->rows;
    scene.def->clay.sectors = grid->sectors;
    files::log_line(scene.file.filename().string() +
                    ", as found here before: " + tuning::words_of(*grid));
    return true;
  });
  tune_next();
}

void Scenes::tune_next() {
  tuner_.reset();
  if (to_tune_.empty()) return;
  files::log_line("Looking for the grid of " + to_tune_.front().file.filename().string() +
                  " on this machine, in the background.");
  tuner_ = std::make_unique<tuning::BackgroundTuner>(to_tune_.front().file.stem().string(),
                                                     *to_tune_.front().def, plan_);
}

void Scenes::take_up_tuned() {
  if (!tuner_) return;
  const auto found = tuner_->take();
  if (!found) return;
  const ToTune scene = to_tune_.front();
  to_tune_.erase(to_tune_.begin());
  if (*found) {
    scene.def->clay.rows = (*found)->rows;
    scene.def->clay.sectors = (*found)->sectors;
    files::log_line(scene.file.filename().string() +
                    ", from the next pot on: " + tuning::words_of(**found));
    if (const auto kept = tuning::remember(scene.memory, **found, machine_); !kept)
      files::log_problem(kept.error());
  } else {
    files::log_problem(found->error());
  }
  tune_next();
}

const SceneDef& Scenes::of(const std::string& id) const {
  const auto own = vessels_.find(id);
  return own != vessels_.end() ? own->second : exhibits_;
}

std::vector<int> Scenes::in_order(const std::vector<std::string>& own) const {
  std::vector<int> order;
  for (const std::string& id : own)
    for (int n = 0; n < static_cast<int>(glazes_.size()); ++n)
      if (glazes_[static_cast<std::size_t>(n)].id == id &&
          std::ranges::find(order, n) == order.end())
        order.push_back(n);
  for (int n = 0; n < static_cast<int>(glazes_.size()); ++n)
    if (std::ranges::find(order, n) == order.end()) order.push_back(n);
  return order;
}

const decoration::Way* Scenes::way_of(const content::Vessel& vessel) const {
  if (!decorates_) return nullptr;
  const WayFound found = find_way(ways_, vessel.way, vessel.id);
  if (found.problem && said_.insert(vessel.id).second) files::log_problem(*found.problem);
  return found.way;
}

const SceneDef* Scenes::built(const content::Vessel& vessel) const {
  return vessel.built && built_ && built_->building ? built_.get() : nullptr;
}

screens::SceneForVisitor Scenes::for_visitor(const SceneDef& def,
                                             const content::Vessel& vessel) const {
  screens::SceneForVisitor wheel;
  wheel.way = way_of(vessel);
  wheel.max_speed = def.wheel.max_speed;
  wheel.tool_radius = wheel.palm_radius = def.tool.radius;
  wheel.shown.clear();
  wheel.keeps_clay = def.volume.has_value();
  wheel.tear_thickness = def.walls ? def.walls->tear_thickness : 0.0;
  for (std::size_t n = 0; n < def.tools.size() && !def.paper; ++n) {
    const auto tool = static_cast<std::uint8_t>(n + 1);
    const ToolShape& shape = *find_tool_shape(def.tools[n].name);
    const ToolSize size = sized(shape, def.tools[n].size);
    switch (shape.role) {
      case ToolRole::outer_hand:
        wheel.palm = tool, wheel.palm_radius = size.radius;
        break;
      case ToolRole::rib:
        wheel.rib = screens::SceneForVisitor::Rib{tool, size.length, size.thickness};
        break;
      case ToolRole::trimmer:
        wheel.trimmer = screens::SceneForVisitor::Trimmer{tool, size.radius};
        break;
      case ToolRole::none:
        break;
    }
    if (shape.severs()) wheel.wire = tool;
    const Vec3 at{kAway, kAway, 0};
    const ToolPlace held = hold_tool(shape, at, {}, 0.0, false);
    const body::Ball inmost = shape.support(held, size, {-1, 0, 0});
    const body::Ball lowest = shape.support(held, size, {0, -1, 0});
    wheel.tools.push_back({tool, def.tools[n].name, kAway - inmost.middle.x + inmost.radius,
                           kAway - lowest.middle.y + lowest.radius});
  }
  std::stable_sort(wheel.tools.begin(), wheel.tools.end(), [](const auto& a, const auto& b) {
    return find_tool_shape(a.name)->tray < find_tool_shape(b.name)->tray;
  });
  if (def.building) {
    wheel.coil = def.building->coil;
    wheel.pace = def.building->pace;
    wheel.floor = scene::built_floor(def.clay);
    wheel.moisture = def.moisture;
    wheel.tools.insert(wheel.tools.begin(), {0, kCoil, 0.5 * *wheel.coil, 0.5 * *wheel.coil});
  }
  if (def.beating) {
    wheel.beating = def.beating;
    wheel.tools.insert(wheel.tools.begin() + (wheel.coil ? 1 : 0),
                       {0, std::string(scene::kPaddle), def.beating->face, def.beating->face});
    SceneDef taken = def;
    take_paddle(taken, vessel);
    wheel.prints = taken.prints;
  }
  for (const std::string& script : attract_scripts_)
    if (const ScriptInfo* info = find_script(script);
        info != nullptr &&
        (info->shows.empty() ? info->needs.target : shows_its_effect(*info, def)))
      wheel.shown.push_back(script);
  if (wheel.shown.empty()) wheel.shown.push_back("follow");
  // Nobody can throw a floor.
  if (def.building) std::ranges::replace(wheel.shown, std::string("follow"), std::string("build"));
  if (def.kiln && !glazes_.empty())
    wheel.kiln =
        screens::Kiln{size_after(*def.kiln, {1.0, 0.0}), size_after(*def.kiln, {1.0, 1.0}),
                      def.kiln->glaze_thickness / kUsualCoat, &glazes_, in_order(vessel.glazes)};
  return wheel;
}

void take_paddle(SceneDef& def, const content::Vessel& vessel) {
  if (!def.beating || !vessel.paddle) return;
  if (!def.prints && *vessel.paddle == PrintsDef::plain) return;  // such a scene shows no print
  if (!def.prints) def.prints.emplace();
  def.prints->paddle = *vessel.paddle;
}

settings::Problems unknown_names(const settings::Exhibit& exhibit,
                                 const std::vector<std::string>& ids) {
  toml::TomlReader reader(exhibit.file);
  auto root = reader.root();
  if (exhibit.build && exhibit.built_scene && builds_nothing(*exhibit.built_scene))
    root.complain("built_scene",
                  exhibit.built_scene->string() + " has no [building], so nothing is built in it.",
                  "Name a scene that has, such as scenes/built.toml, or remove the line.");
  const auto remedy = [&ids](const std::string& id, const char* otherwise) {
    const std::string nearest = nearest_name(id, ids);
    return nearest.empty() ? otherwise : "Did you mean " + nearest + "?";
  };
  for (const auto& [key, listed] :
       {std::pair{"order", &exhibit.order}, {"hidden", &exhibit.hidden}})
    for (std::size_t n = 0; root.has(key) && n < listed->size(); ++n)
      if (const std::string& id = (*listed)[n]; std::ranges::find(ids, id) == ids.end())
        root.complain_at(key, n, "There is no vessel \"" + id + "\" on the shelf.",
                         remedy(id, "Write the name of its folder on the shelf, or remove it."));
  auto scenes = root.child("vessel_scenes");
  for (const auto& [id, scene] : exhibit.vessel_scenes) {
    if (std::ranges::find(ids, id) != ids.end()) continue;
    scenes.complain(id, "There is no vessel \"" + id + "\" on the shelf.",
                    remedy(id, "Write the name of its folder on the shelf, or remove the line."));
  }
  std::vector<std::string> shown;  // "follow", and scripts that show an effect
  for (const ScriptInfo& script : scripts())
    if (script.needs.target || !script.shows.empty()) shown.emplace_back(script.name);
  auto attract = root.child("attract");
  for (std::size_t n = 0; n < exhibit.attract_scripts.size(); ++n) {
    const std::string& script = exhibit.attract_scripts[n];
    if (std::ranges::find(shown, script) != shown.end()) continue;
    attract.complain_at("scripts", n, "Attract mode has no script \"" + script + "\".",
                        "Choose one of " + joined(shown) + ".");
  }
  return reader.problems();
}

}  // namespace onggi::exhibit
