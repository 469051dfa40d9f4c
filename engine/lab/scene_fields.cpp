#include "engine/lab/scene_fields.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace onggi::lab {
namespace {

bool always(const SceneDef&) { return true; }

// Lengths of the clay bound each other: those that are not `kept` make room for the one that is.
void make_room(ClayDef& clay, const double* kept) {
  if (kept == &clay.floor_thickness) clay.height = std::max(clay.height, *kept);
  clay.floor_thickness = std::min(clay.floor_thickness, clay.height);
  if (kept == &clay.radius_max || kept == &clay.outer_radius) {
    const double room = *kept;
    clay.wall_min = std::clamp(0.25 * room, 0.0005, clay.wall_min);
    clay.radius_min = std::clamp(0.1 * room, 1e-4, clay.radius_min);
    clay.inner_radius = std::clamp(0.3 * room, clay.radius_min, clay.inner_radius);
    if (clay.inner_radius + clay.wall_min >= room) clay.inner_radius = clay.radius_min;
    if (kept == &clay.radius_max)
      clay.outer_radius = std::min(clay.outer_radius, 0.95 * room);
    else
      clay.radius_max = std::max(clay.radius_max, std::min(1.0, 1.5 * room));
    return;
  }
  if (kept == &clay.inner_radius) clay.radius_min = std::min(clay.radius_min, *kept);
  clay.inner_radius = std::max(clay.inner_radius, clay.radius_min);
  clay.outer_radius = std::max(clay.outer_radius, clay.inner_radius + 2.0 * clay.wall_min);
  clay.radius_max = std::max(clay.radius_max, std::min(1.0, 1.5 * clay.outer_radius));
}

SceneField length_of_clay(const char* name, double least, double most, double ClayDef::*field,
                          bool bounded) {
  return {name,
          least,
          most,
          bounded,
          always,
          [field](const SceneDef& def) { return def.clay.*field; },
          [field](SceneDef& def, double value) {
            def.clay.*field = value;
            make_room(def.clay, &(def.clay.*field));
            // A wall that tears does so before it is as thin as it can be.
            if (def.walls && def.walls->tear_thickness > 0.0)
              def.walls->tear_thickness =
                  std::max(def.walls->tear_thickness, std::nextafter(def.clay.wall_min, 1.0));
          }};
}

void add_clay(std::vector<SceneField>& fields) {
  fields.push_back({"clay.rows", 8, 20000, false, always,
                    [](const SceneDef& def) { return def.clay.rows; },
                    [](SceneDef& def, double value) { def.clay.rows = static_cast<int>(value); }});
  fields.push_back(
      {"clay.sectors", 16, 8192, false, always,
       [](const SceneDef& def) { return def.clay.sectors; },
       [](SceneDef& def, double value) { def.clay.sectors = static_cast<int>(value); }});
  fields.push_back(length_of_clay("clay.height", 0.01, 1.0, &ClayDef::height, false));
  // radius_min + wall_min at the least, and less than radius_max at the most.
  fields.push_back(
      length_of_clay("clay.outer_radius", 0.00061, 0.9999, &ClayDef::outer_radius, true));
  fields.push_back(length_of_clay("clay.inner_radius", 1e-4, 0.95, &ClayDef::inner_radius, true));
  fields.push_back(
      length_of_clay("clay.floor_thickness", 0.0, 1.0, &ClayDef::floor_thickness, false));
  fields.push_back(length_of_clay("clay.floor_min", 0.0005, 0.05, &ClayDef::floor_min, false));
  fields.push_back(length_of_clay("clay.wall_min", 0.0005, 0.02, &ClayDef::wall_min, false));
  fields.push_back(length_of_clay("clay.radius_min", 1e-4, 0.5, &ClayDef::radius_min, false));
  fields.push_back(length_of_clay("clay.radius_max", 0.005, 1.0, &ClayDef::radius_max, false));
}

template <class Part>
SceneField plain(const char* name, double least, double most, Part SceneDef::*part,
                 double Part::*field) {
  return {name,
          least,
          most,
          false,
          always,
          [=](const SceneDef& def) { return def.*part.*field; },
          [=](SceneDef& def, double value) { def.*part.*field = value; }};
}

// Calls `visit` with the effect at place `n`, a std::optional.
template <class AnySceneDef, class Visit>
void at_place(AnySceneDef& def, std::size_t n, const Visit& visit) {
  std::size_t at = 0;
  each_effect(def, [&](auto& effect) {
    if (at++ == n) visit(effect);
  });
}

void add_effects(std::vector<SceneField>& fields) {
  std::size_t n = 0;
  SceneDef all;
  each_effect(all, [&]<class Def>(std::optional<Def>&) {
    for (const EffectField<Def>& field : Def::fields()) {
      const auto value = field.value;
      SceneField out;
      out.name = std::string(Def::kName) + "." + field.key;
      out.least = field.least;
      out.most = field.most;
      out.bounded = out.name == "walls.tear_thickness";  // 0, or more than wall_min
      out.there = [n](const SceneDef& def) { return has_effect(def, n); };
      out.get = [n, value](const SceneDef& def) {
        double found = 0.0;
        at_place(def, n, [&]<class One>(const std::optional<One>& effect) {
          if constexpr (std::is_same_v<One, Def>) found = (*effect).*value;
        });
        return found;
      };
      out.set = [n, value](SceneDef& def, double wanted) {
        if (!has_effect(def, n)) add_effect(def, n);
        at_place(def, n, [&]<class One>(std::optional<One>& effect) {
          if constexpr (std::is_same_v<One, Def>)
            if (effect) (*effect).*value = wanted;
        });
        if (def.walls && def.walls->tear_thickness > 0.0 &&
            def.walls->tear_thickness <= def.clay.wall_min)
          def.clay.wall_min = std::max(0.0005, 0.5 * def.walls->tear_thickness);
      };
      fields.push_back(std::move(out));
    }
    ++n;
  });
}

void add_paper(std::vector<SceneField>& fields) {
  const auto add = [&](const char* name, double least, double most, double PaperDef::*field) {
    fields.push_back({name, least, most, false,
                      [](const SceneDef& def) { return def.paper.has_value(); },
                      [=](const SceneDef& def) { return (*def.paper).*field; },
                      [=](SceneDef& def, double value) {
                        if (!def.paper) {
                          def = bare(std::move(def));
                          def.paper.emplace();
                        }
                        (*def.paper).*field = value;
                      }});
  };
  add("paper.c_eta", 0.5, 1000.0, &PaperDef::c_eta);
  add("paper.c_v", 0.0, 1000.0, &PaperDef::c_v);
  add("paper.c_r", 0.0, 1e5, &PaperDef::c_r);
}

void add_tools(std::vector<SceneField>& fields) {
  const auto add = [&](const ToolShape& shape, const char* field, double ToolSize::*part) {
    if (shape.usual.*part == 0.0 || shape.name == "sphere") return;
    const auto mine = [name = std::string(shape.name)](auto& def) {
      return std::ranges::find(def.tools, name, &ToolToHand::name);
    };
    fields.push_back({std::string(shape.name) + "." + field, shape.least.*part, shape.most.*part,
                      false, [mine](const SceneDef& def) { return mine(def) != def.tools.end(); },
                      [mine, part](const SceneDef& def) { return mine(def)->size.*part; },
                      [mine, part](SceneDef& def, double value) {
                        if (const auto at = mine(def); at != def.tools.end())
                          at->size.*part = value;
                      }});
  };
  for (const ToolShape& shape : tool_shapes()) {
    add(shape, "radius", &ToolSize::radius);
    add(shape, "length", &ToolSize::length);
    add(shape, "thickness", &ToolSize::thickness);
  }
}

}  // namespace

std::vector<SceneField> scene_fields() {
  std::vector<SceneField> fields;
  add_clay(fields);
  fields.push_back(plain("tool.radius", 0.001, 0.05, &SceneDef::tool, &ToolDef::radius));
  fields.push_back(plain("contact.relaxation_time", 0.001, 1.0, &SceneDef::contact,
                         &ContactDef::relaxation_time));
  fields.push_back(
      plain("contact.stiffness", 1e5, 5e7, &SceneDef::contact, &ContactDef::stiffness));
  fields.push_back(plain("wheel.max_speed", 0.0, 62.9, &SceneDef::wheel, &WheelDef::max_speed));
  fields.push_back(
      plain("wheel.acceleration", 0.1, 1000.0, &SceneDef::wheel, &WheelDef::acceleration));
  fields.push_back(plain("guard.max_force", 0.0, 22.2, &SceneDef::guard, &GuardDef::max_force));
  fields.push_back(plain("guard.max_slew", 10.0, 1e5, &SceneDef::guard, &GuardDef::max_slew));
  fields.push_back(plain("guard.engage_time", 0.05, 5.0, &SceneDef::guard, &GuardDef::engage_time));
  add_effects(fields);
  add_paper(fields);
  add_tools(fields);
  return fields;
}

SceneDef bare(SceneDef def) {
  each_effect(def, [](auto& effect) { effect.reset(); });
  def.paper.reset();
  return def;
}

std::vector<std::string> effect_names() {
  std::vector<std::string> names;
  SceneDef any;
  each_effect(any, [&]<class Def>(const std::optional<Def>&) { names.emplace_back(Def::kName); });
  return names;
}

void add_effect(SceneDef& def, std::size_t n) {
  if (def.paper) return;
  at_place(def, n, [](auto& effect) { effect.emplace(); });
  if (def.slump && !def.volume) def.volume.emplace();
}

void remove_effect(SceneDef& def, std::size_t n) {
  at_place(def, n, [](auto& effect) { effect.reset(); });
  if (def.slump && !def.volume) def.slump.reset();
}

bool has_effect(const SceneDef& def, std::size_t n) {
  bool there = false;
  at_place(def, n, [&](const auto& effect) { there = effect.has_value(); });
  return there;
}

}  // namespace onggi::lab
