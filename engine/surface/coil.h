#pragma once

#include <span>

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"
#include "engine/surface/station.h"

namespace onggi::surface {

/// A thin coil of clay that is pressed onto the pot with the fingernail as the wheel turns (the
/// chain band of an onggi jar): a bead with slanting nail marks. It is a part of the pot: a brush
/// does not take it away as it does a burr, a scraper does.
struct CoilDef {
  int marks = 60;         ///< Of the nail, once round the pot, 8..120.
  int turn = 0;           ///< Sectors by which the marks are turned, 0..kSectors - 1.
  double width = 0.006;   ///< Of the bead, m, 0.002..0.015.
  double height = 0.002;  ///< Over the reference body, at whole pressure, m, 0..0.003.
  double press = 0.6;     ///< Of its height, how deep the nail goes, 0..1.

  static constexpr const char* kName = "coil";
  static std::span<const DefField<CoilDef, int>> counts();
  static std::span<const DefField<CoilDef>> fields();
};

/// Lays the coil along `stations`. Twice is once. `def` and `stations` are valid (laws.h).
Work coil(Surface& surface, const CoilDef& def, std::span<const Station> stations);

}  // namespace onggi::surface
