#include "engine/clay/clay_def.h"

namespace onggi {

std::span<const DefField<ClayDef, int>> ClayDef::counts() {
  static constexpr DefField<ClayDef, int> kCounts[] = {
      {"rows", &ClayDef::rows, 8, 20000, ""},
      {"sectors", &ClayDef::sectors, 16, clay::kMostSectors, ""},
  };
  return kCounts;
}

std::span<const DefField<ClayDef>> ClayDef::fields() {
  static constexpr DefField<ClayDef> kFields[] = {
      {"height", &ClayDef::height, 0.01, 1.0, "m"},
      {"outer_radius", &ClayDef::outer_radius, 0.0, 1.0, "m"},
      {"inner_radius", &ClayDef::inner_radius, 1e-4, 1.0, "m"},
      {"floor_thickness", &ClayDef::floor_thickness, 0.0, 1.0, "m"},
      {"floor_min", &ClayDef::floor_min, 0.0005, 0.05, "m"},
      {"wall_min", &ClayDef::wall_min, 0.0005, 0.02, "m"},
      {"radius_min", &ClayDef::radius_min, 1e-4, 0.5, "m"},
      {"radius_max", &ClayDef::radius_max, 0.005, 1.0, "m"},
  };
  return kFields;
}

std::span<const DefField<ClayDef, bool>> ClayDef::switches() {
  static constexpr DefField<ClayDef, bool> kSwitches[] = {
      {"keep_undo", &ClayDef::keep_undo, 0, 1, ""},
  };
  return kSwitches;
}

Result<void> validate(const ClayDef& def, const std::string& where) {
  constexpr double kMostElements = 32.0 * 1024 * 1024;
  FieldCheck check(where);
  check_fields(check, def);
  const double elements = static_cast<double>(def.rows) * def.sectors;
  check.require(elements <= kMostElements, "rows",
                "times sectors makes " + number_text(elements) +
                    " elements, more than the 33.5 million a grid may have.",
                "Lower rows or sectors: 400 x 360 is enough for the eye and the hand.");
  check.range("inner_radius", def.inner_radius, def.radius_min, 1.0, "m");
  check.require(def.outer_radius < def.radius_max, "outer_radius",
                "is " + number_text(def.outer_radius) + " m, not below radius_max (" +
                    number_text(def.radius_max) + " m), so the clay could not be widened.",
                "Make outer_radius smaller or radius_max larger.");
  check.require(def.outer_radius > def.inner_radius + def.wall_min, "outer_radius",
                "is " + number_text(def.outer_radius) +
                    " m, which leaves less than wall_min beyond inner_radius.",
                "Make it more than inner_radius + wall_min (" +
                    number_text(def.inner_radius + def.wall_min) + " m).");
  check.range("floor_thickness", def.floor_thickness, 0.0, def.height, "m");
  return check.result();
}

}  // namespace onggi
