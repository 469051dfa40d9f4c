#include "engine/lab/scene_fields.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

namespace onggi::lab {
namespace {

bool always(const SceneDef&) { return true; }

// Lengths of the clay bound each other. All but `kept` make room for it.
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

// A wall must tear before it reaches its thinnest.
void keep_tearing_above(SceneDef& def) {
  if (def.walls && def.walls->tear_thickness > 0.0)
    def.walls->tear_thickness =
        std::max(def.walls->tear_thickness, std::nextafter(def.clay.wall_min, 1.0));
}

// The range that other lengths leave to one: radius_min + wall_min at least, and less than
// radius_max.
void bound(SceneField& field) {
  const auto to = [&](double least, double most) {
    field.bounded = true;
    field.least = least;
    field.most = most;
  };
  if (field.name == "clay.outer_radius") to(0.00061, 0.9999);
  if (field.name == "clay.inner_radius") to(1e-4, 0.95);
}

template <class Part, class Value>
SceneField number_of(Part SceneDef::*part, const DefField<Part, Value>& number) {
  const auto value = number.value;
  SceneField field;
  field.name = std::string(Part::kName) + "." + number.key;
  field.least = number.least;
  field.most = number.most;
  bound(field);
  field.there = always;
  field.get = [=](const SceneDef& def) { return static_cast<double>(def.*part.*value); };
  field.set = [=](SceneDef& def, double wanted) {
    def.*part.*value = static_cast<Value>(wanted);
    if constexpr (std::is_same_v<Part, ClayDef> && std::is_same_v<Value, double>) {
      make_room(def.clay, &(def.clay.*value));
      keep_tearing_above(def);
    }
  };
  return field;
}

void add_parts(std::vector<SceneField>& fields) {
  std::apply(
      [&]<class... Part>(Part SceneDef::*... part) {
        const auto add = [&]<class One>(One SceneDef::*one) {
          each_field<One>([&]<class Value>(const DefField<One, Value>& number) {
            if constexpr (!std::is_same_v<Value, bool>) fields.push_back(number_of(one, number));
          });
        };
        (add(part), ...);
      },
      kSceneParts);
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
    for (const DefField<Def>& field : Def::fields()) {
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
  for (const DefField<PaperDef>& number : PaperDef::fields()) {
    const auto value = number.value;
    fields.push_back({std::string(PaperDef::kName) + "." + number.key, number.least, number.most,
                      false, [](const SceneDef& def) { return def.paper.has_value(); },
                      [=](const SceneDef& def) { return (*def.paper).*value; },
                      [=](SceneDef& def, double wanted) {
                        if (!def.paper) {
                          def = bare(std::move(def));
                          def.paper.emplace();
                        }
                        (*def.paper).*value = wanted;
                      }});
  }
}

void add_tools(std::vector<SceneField>& fields) {
  const auto add = [&](const ToolShape& shape, const char* field, double ToolSize::*part) {
    if (shape.usual.*part == 0.0 || shape.name == "sphere") return;
    const auto mine = [name = std::string(shape.name)](auto& def) {
      return std::ranges::find(def.tools, name, &SceneTool::name);
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
  add_parts(fields);
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
  if (def.prints && !def.beating) def.beating.emplace();
  if ((def.slump || def.building || def.beating) && !def.volume) def.volume.emplace();
}

void remove_effect(SceneDef& def, std::size_t n) {
  at_place(def, n, [](auto& effect) { effect.reset(); });
  if (!def.volume) {
    def.slump.reset();
    def.building.reset();
    def.beating.reset();
  }
  if (!def.beating) def.prints.reset();
}

bool has_effect(const SceneDef& def, std::size_t n) {
  bool there = false;
  at_place(def, n, [&](const auto& effect) { there = effect.has_value(); });
  return there;
}

}  // namespace onggi::lab
