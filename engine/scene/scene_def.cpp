#include "engine/scene/scene_def.h"

#include <string>
#include <type_traits>

namespace onggi {
namespace {

constexpr std::size_t kMostTools = 63;

Result<void> check_size(const SceneTool& tool, const ToolShape& shape) {
  FieldCheck check(tool.name);
  const auto part = [&](const char* field, double ToolSize::*of) {
    const double value = tool.size.*of;
    if (shape.usual.*of > 0.0) {
      if (value != 0.0) check.range(field, value, shape.least.*of, shape.most.*of, "m");
    } else {
      check.require(value == 0.0, field,
                    "is given, and this tool has no " + std::string(field) + ".", "Leave it out.");
    }
  };
  part("radius", &ToolSize::radius);
  part("length", &ToolSize::length);
  part("thickness", &ToolSize::thickness);
  return check.result();
}

Result<void> check_tools(const SceneDef& def) {
  if (def.tools.size() > kMostTools)
    return problem("tools", "There are more than " + std::to_string(kMostTools) + " tools to hand.",
                   "Leave some out.");
  for (const SceneTool& tool : def.tools) {
    const ToolShape* shape = find_tool_shape(tool.name);
    if (shape == nullptr)
      return problem("tools", "There is no tool \"" + tool.name + "\".",
                     "Choose one of engine/docs/tools.md.");
    if (auto good = check_size(tool, *shape); !good) return good;
  }
  return {};
}

Result<void> check_parts(const SceneDef& def) {
  Result<void> good;
  each_part(def, [&]<class Part>(const Part& part) {
    if constexpr (std::is_same_v<Part, ClayDef>)
      good = validate(part, Part::kName);
    else if (good)
      good = check_fields(part);
  });
  return good;
}

Result<void> check_effects(const SceneDef& def) {
  Result<void> good;
  each_effect(def, [&](const auto& effect) {
    if (good && effect) good = check_fields(*effect);
  });
  return good;
}

// Checks that effects have the effects they need.
Result<void> check_needs(const SceneDef& def) {
  const auto needs = [](const char* name, bool there, const char* other) -> Result<void> {
    if (there) return {};
    return problem(name, std::string(name) + " needs " + other + ".",
                   std::string("Add a [") + other + "] table or remove [" + name + "].");
  };
  const bool volume = def.volume.has_value();
  if (def.slump && !volume) return needs(SlumpDef::kName, volume, VolumeDef::kName);
  if (def.building && !volume) return needs(BuildingDef::kName, volume, VolumeDef::kName);
  if (def.beating && !volume) return needs(BeatingDef::kName, volume, VolumeDef::kName);
  if (def.prints) return needs(PrintsDef::kName, def.beating.has_value(), BeatingDef::kName);
  return {};
}

// Checks for a tearing limit that the wall can never reach.
Result<void> check_tearing(const SceneDef& def) {
  if (!def.walls || def.walls->tear_thickness == 0.0) return {};
  FieldCheck check(WallsDef::kName);
  check.require(def.walls->tear_thickness > def.clay.wall_min, "tear_thickness",
                "is not more than clay.wall_min, and no wall gets thinner than that.",
                "Make it larger than clay.wall_min, or 0 for walls that never tear.");
  return check.result();
}

// Rows that a built pot may come to have.
Result<void> check_building(const SceneDef& def) {
  if (!def.building) return {};
  constexpr double kMostElements = 32.0 * 1024 * 1024;  // as of clay.rows
  const double rows = def.clay.rows + effects::Building::spare_rows(*def.building, def.clay);
  FieldCheck check(BuildingDef::kName);
  check.require(rows * def.clay.sectors <= kMostElements, "tallest",
                "needs " + number_text(std::floor(rows)) +
                    " rows as thin as those of the clay, more than 32 million elements.",
                "Lower it, clay.rows or clay.sectors.");
  return check.result();
}

Result<void> check_paper(const SceneDef& def) {
  if (!def.paper) return {};
  FieldCheck check(PaperDef::kName);
  check_fields(check, *def.paper);
  const char* beside = nullptr;
  each_effect(def, [&]<class Def>(const std::optional<Def>& effect) {
    if (effect && beside == nullptr) beside = Def::kName;
  });
  if (beside != nullptr)
    check.require(
        false, "c_r",
        std::string("stands beside ") + beside + ", and the paper's model has no effects.",
        std::string("Leave out ") + beside + ", or leave out paper.");
  return check.result();
}

}  // namespace

std::span<const DefField<ToolDef>> ToolDef::fields() {
  static constexpr DefField<ToolDef> kFields[] = {
      {"radius", &ToolDef::radius, 0.001, 0.05, "m"},
  };
  return kFields;
}

std::span<const DefField<ContactDef>> ContactDef::fields() {
  static constexpr DefField<ContactDef> kFields[] = {
      {"relaxation_time", &ContactDef::relaxation_time, 0.001, 1.0, "s"},
      {"stiffness", &ContactDef::stiffness, 1e5, 5e7, "N/m per m^2"},
  };
  return kFields;
}

std::span<const DefField<WheelDef>> WheelDef::fields() {
  static constexpr DefField<WheelDef> kFields[] = {
      {"max_speed", &WheelDef::max_speed, 0.0, 62.9, "rad/s"},
      {"acceleration", &WheelDef::acceleration, 0.1, 1000.0, "rad/s^2"},
  };
  return kFields;
}

std::span<const DefField<GuardDef>> GuardDef::fields() {
  static constexpr DefField<GuardDef> kFields[] = {
      {"max_force", &GuardDef::max_force, 0.0, 22.2, "N"},
      {"max_slew", &GuardDef::max_slew, 10.0, 1e5, "N/s"},
      {"engage_time", &GuardDef::engage_time, 0.05, 5.0, "s"},
  };
  return kFields;
}

std::span<const DefField<PaperDef>> PaperDef::fields() {
  static constexpr DefField<PaperDef> kFields[] = {
      {"c_eta", &PaperDef::c_eta, 0.5, 1000.0, "ticks"},
      {"c_v", &PaperDef::c_v, 0.0, 1000.0, "N/m"},
      {"c_r", &PaperDef::c_r, 0.0, 1e5, "N/m"},
  };
  return kFields;
}

std::vector<SceneTool> usual_tools() {
  std::vector<SceneTool> tools;
  for (const ToolShape& shape : tool_shapes())
    if (shape.name != "sphere") tools.push_back({std::string(shape.name), {}});
  return tools;
}

Result<void> validate(const SceneDef& def) {
  Result<void> good;
  for (auto check : {check_parts, check_tools, check_effects, check_needs, check_tearing,
                     check_building, check_paper})
    if (good) good = check(def);
  return good;
}

}  // namespace onggi
