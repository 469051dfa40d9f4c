#pragma once

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"

namespace onggi::surface {

/// The pot is dipped into glaze or slip, or some is poured over a zone or into the pot. The coat
/// grows with the square root of time, as water goes into the wall, and only as long as the wall
/// drinks.
struct DipDef {
  static constexpr int kGlaze = kPigments;
  int coat = kGlaze;            ///< A pigment's slip, 0..15, or the glaze.
  double from = 0.0, to = 0.0;  ///< The zone that is under, m along the outline, 0..2.
  double seconds = 4.0;         ///< 0.1..60.
  double rate = 4e-4;           ///< Of the raw coat after one second, m, 1e-5..1e-3.
  double drinks = 0.25;         ///< Thickest coat for the wall's thickness, 0.01..1.

  static constexpr const char* kName = "dip";
  static std::span<const DefField<DipDef, int>> counts();
  static std::span<const DefField<DipDef>> fields();
};

/// Dips, but for cells with resist. Twice the half of the time gives as much as once, to a unit.
/// `def` is valid (laws.h).
Work dip(Surface& surface, const DipDef& def);

}  // namespace onggi::surface
