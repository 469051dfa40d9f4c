#pragma once

#include <string>

#include "engine/base/def_field.h"

namespace onggi::clay {
/// Size of a grid.
inline constexpr int kMostSectors = 8192;
}  // namespace onggi::clay

namespace onggi {

/// The lump on the wheel: a thick-walled cylinder with a floor, and the grid that carries it.
struct ClayDef {
  int rows = 400;                  ///< Rows over the height, 8..20000.
  int sectors = 360;               ///< Sectors round the axis, 16..8192.
  double height = 0.20;            ///< Metres, 0.01..1.
  double outer_radius = 0.055;     ///< Metres, > inner_radius + wall_min, < radius_max.
  double inner_radius = 0.022;     ///< Metres, >= radius_min.
  double floor_thickness = 0.010;  ///< Metres; rows below it are solid. 0..height; at the height
                                   ///< the lump is solid, for a potter to open.
  double floor_min = 0.004;  ///< Thinnest floor that pressing leaves, metres, 0.0005..0.05. A floor
                             ///< that begins thinner is firm.
  double wall_min = 0.004;   ///< Thinnest wall, metres, 0.0005..0.02. Pressing further carries the
                             ///< other side along.
  double radius_min = 0.002;  ///< Smallest inner radius above the floor, metres, > 0.
  double radius_max = 0.16;   ///< Largest outer radius, metres, <= 1.
  bool keep_undo = true;      ///< Strokes, and new clay, can be taken back (history.h): doubles the
                              ///< memory, and 32 MiB more.

  static constexpr const char* kName = "clay";
  static std::span<const DefField<ClayDef, int>> counts();
  static std::span<const DefField<ClayDef>> fields();
  static std::span<const DefField<ClayDef, bool>> switches();
};

/// Checks every field; `where` prefixes the field's name in the Problem. Nothing is allocated.
Result<void> validate(const ClayDef& def, const std::string& where);

}  // namespace onggi
