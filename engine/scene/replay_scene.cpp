#include "engine/scene/replay_scene.h"

#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

namespace onggi::replay_bytes {
namespace {

constexpr std::size_t kLongestName = 64;

bool tool_list(auto& io, auto& tools) {
  auto count = static_cast<std::uint8_t>(tools.size());
  if (!io(count)) return false;
  tools.resize(count);
  for (SceneTool& tool : tools)
    if (!io.text(tool.name, kLongestName) || !io(tool.size.radius) || !io(tool.size.length) ||
        !io(tool.size.thickness))
      return false;
  return true;
}

// A number of a scene, by key. Each is written as a double, which holds every type exactly.
struct Place {
  double* number = nullptr;
  int* count = nullptr;
  bool* is_on = nullptr;

  explicit operator bool() const { return number != nullptr || count != nullptr || is_on; }
  void point_to(double& v) { number = &v; }
  void point_to(int& v) { count = &v; }
  void point_to(bool& v) { is_on = &v; }
  bool put(double v) const {
    if (number != nullptr) *number = v;
    if (count != nullptr) {
      if (!(std::fabs(v) <= std::numeric_limits<int>::max()) || v != std::trunc(v)) return false;
      *count = static_cast<int>(v);
    }
    if (is_on != nullptr) {
      if (v != 0.0 && v != 1.0) return false;
      *is_on = v == 1.0;
    }
    return true;
  }
};

// Calls `visit` with the part, effect or paper model called `name`; optional ones are added. False
// if unknown.
template <class Visit>
bool at_table(SceneDef& def, std::string_view name, Visit&& visit) {
  bool found = false;
  const auto part = [&]<class Def>(Def& one) {
    if (name != Def::kName) return;
    found = true;
    visit(one);
  };
  const auto optional = [&]<class Def>(std::optional<Def>& one) {
    if (name == Def::kName) part(one ? *one : one.emplace());
  };
  each_part(def, part);
  each_effect(def, optional);
  optional(def.paper);
  return found;
}

// Empty if there is no such key.
Place place_of(SceneDef& def, std::string_view table, std::string_view key) {
  Place place;
  at_table(def, table, [&]<class Def>(Def& one) {
    each_field<Def>([&](const auto& field) {
      if (key == field.key || (field.formerly != nullptr && key == field.formerly))
        place.point_to(one.*(field.value));
    });
  });
  return place;
}

// An empty name ends the tables; an empty key ends a table.
bool read_table(Reader& io, SceneDef& def, std::string_view table, std::string& unknown) {
  for (std::string key;;) {
    if (!io.text(key, kLongestName)) return false;
    if (key.empty()) return true;
    double value = 0.0;
    const Place place = place_of(def, table, key);
    if (!place) unknown = std::string(table) + "." + key;
    if (!place || !io(value) || !place.put(value)) return false;
  }
}

bool read_tables(Reader& io, SceneDef& def, std::string& unknown) {
  for (std::string table;;) {
    if (!io.text(table, kLongestName)) return false;
    if (table.empty()) return true;
    if (!at_table(def, table, [](auto&) {})) {
      unknown = table;
      return false;
    }
    if (!read_table(io, def, table, unknown)) return false;
  }
}

// Version 11 wrote numbers without names, in this order. A byte before each effect and before the
// paper model said whether it followed.
struct OldTable {
  const char* name;
  std::initializer_list<const char*> keys;
};
const OldTable kOldParts[] = {
    {"clay",
     {"rows", "sectors", "height", "outer_radius", "inner_radius", "floor_thickness", "floor_min",
      "wall_min", "radius_min", "radius_max", "keep_undo"}},
    {"tool", {"radius"}},
    {"contact", {"relaxation_time", "stiffness"}},
    {"wheel", {"max_speed", "acceleration"}},
    {"guard", {"max_force", "max_slew", "engage_time"}},
};
const OldTable kOldEffects[] = {
    {"moisture", {"wetting_time", "drying_time", "softening", "weakening", "air", "sponge_height"}},
    {"walls", {"support", "tear_thickness", "tear_strain", "yield_stress"}},
    {"propagation", {"reach"}},
    {"springback", {"share", "time"}},
    {"smoothing", {"pace"}},
    {"wobble", {"off_centre", "centring_time", "reach"}},
    {"slump", {"yield_stress", "viscosity", "density", "fall"}},
    {"volume", {}},
    {"friction", {"coefficient", "wet_factor", "slip_speed"}},
    {"kiln", {"drying_shrinkage", "firing_shrinkage", "glaze_thickness"}},
    {"paper", {"c_eta", "c_v", "c_r"}},
};

bool read_old_table(Reader& io, SceneDef& def, const OldTable& table) {
  for (const char* key : table.keys) {
    const Place place = place_of(def, table.name, key);
    if (place.number != nullptr  ? !io(*place.number)
        : place.count != nullptr ? !io(*place.count)
                                 : place.is_on == nullptr || !io(*place.is_on))
      return false;
  }
  return true;
}

bool read_old_scene(Reader& io, SceneDef& def) {
  for (const OldTable& table : kOldParts)
    if (!read_old_table(io, def, table)) return false;
  if (!tool_list(io, def.tools)) return false;
  for (const OldTable& table : kOldEffects) {
    bool there = false;
    if (!io(there)) return false;
    if (there && (!at_table(def, table.name, [](auto&) {}) || !read_old_table(io, def, table)))
      return false;
  }
  return true;
}

}  // namespace

void write_scene(Writer& io, const SceneDef& def) {
  const auto table = [&]<class Def>(const Def& part) {
    io.text(Def::kName, kLongestName);
    each_field<Def>([&](const auto& field) {
      auto value = static_cast<double>(part.*(field.value));
      io.text(field.key, kLongestName);
      io(value);
    });
    io.text("", kLongestName);
  };
  const auto optional = [&](const auto& part) {
    if (part) table(*part);
  };
  each_part(def, table);
  each_effect(def, optional);
  optional(def.paper);
  io.text("", kLongestName);
  std::vector<SceneTool> tools = def.tools;
  tool_list(io, tools);
}

bool read_scene(Reader& io, std::uint32_t version, SceneDef& def, std::string& unknown) {
  def = SceneDef{};
  unknown.clear();
  each_effect(def, [](auto& effect) { effect.reset(); });
  if (version == 11) return read_old_scene(io, def);
  return read_tables(io, def, unknown) && tool_list(io, def.tools);
}

}  // namespace onggi::replay_bytes
