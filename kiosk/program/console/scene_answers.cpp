#include "kiosk/program/console/scene_answers.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "engine/lab/recommend.h"
#include "engine/lab/scene_fields.h"
#include "kiosk/collection/settings/scene_file.h"
#include "kiosk/collection/settings/scene_words.h"
#include "kiosk/exhibit/tuning/grid_memory.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/ground/toml/toml_text.h"
#include "kiosk/program/console/edited_file.h"
#include "kiosk/program/console/said.h"

namespace onggi::console {

namespace {

namespace fs = std::filesystem;
using files::Json;

std::vector<std::string> effects_of(const SceneDef& def) {
  const std::vector<std::string> all = lab::effect_names();
  std::vector<std::string> out;
  for (std::size_t n = 0; n < all.size(); ++n)
    if (lab::has_effect(def, n)) out.push_back(all[n]);
  return out;
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code gone;
  return fs::equivalent(a, b, gone);
}

web::Answer no_such_scene() {
  return refused(404, "There is no such scene here any more.", "Load this page again.");
}

}  // namespace

web::Answer SceneAnswers::scenes(const web::Ask& ask) {
  const settings::Exhibit& exhibit = site_.exhibit();
  Json list = Json::list();
  for (const fs::path& file : scene_files(site_)) {
    const auto text = toml::read_toml_text(file);
    if (!text) continue;
    const SceneDef def = settings::read_scene(file).def;
    Json vessels = Json::list();
    for (const auto& [id, scene] : exhibit.vessel_scenes)
      if (is_same(scene, file)) vessels.push_back(id);
    Json one = Json::object({{"name", file.stem().string()},
                             {"words", settings::words_of_scene(*text)},
                             {"effects", Json::list_of(effects_of(def))},
                             {"thrown", is_same(exhibit.scene, file)},
                             {"built", exhibit.built_scene && is_same(*exhibit.built_scene, file)},
                             {"vessels", vessels}});
    if (const auto known = prices_.of(file, *text, false))
      one["tick_us"] = nlohmann::json::parse(*known).value("whole_us", 0.0);
    list.push_back(one);
  }
  return json(ask, list.text(-1));
}

web::Answer SceneAnswers::prices(const web::Ask& ask, const std::string& name) {
  const auto scene = EditedFile::find(site_, "scene/" + name);
  const auto text = scene ? scene->text() : tl::unexpected(Problem{});
  if (!text) return no_such_scene();
  const settings::SceneRead read = settings::read_scene(scene->path());
  std::string trouble;
  std::optional<std::string> known;
  if (!read.problems.empty())
    trouble = "Prices are told where the scene has no fault.";
  else if (read.def.paper)
    trouble = "This scene runs on the printed model, which has no effects.";
  else
    known = prices_.of(scene->path(), *text, true);
  if (trouble.empty()) trouble = prices_.trouble(*text);
  Json out = Json::object({{"measuring", !known && trouble.empty()},
                           {"trouble", trouble},
                           {"budget", lab::kTickBudget}});
  const fs::path& folder = site_.exhibit().keepsake.folder;
  if (const auto memory = tuning::memory_of(folder, scene->path(), tuning::machine_name()))
    if (const auto grid = tuning::remembered(*memory)) out["grid"] = tuning::words_of(*grid);
  std::string all = out.text(-1);
  all.insert(all.size() - 1, ",\"prices\":" + known.value_or("null"));
  return json(ask, all);
}

web::Answer SceneAnswers::measure(const std::string& name) {
  const auto scene = EditedFile::find(site_, "scene/" + name);
  const auto text = scene ? scene->text() : tl::unexpected(Problem{});
  if (!text) return no_such_scene();
  prices_.forget(*text);
  return json(Json::object());
}

}  // namespace onggi::console
