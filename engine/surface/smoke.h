#pragma once

#include "engine/base/def_field.h"
#include "engine/surface/lay.h"

namespace onggi::surface {

/// Smoke blackens the pot from a height on, over the lip and inside: the black top of a jar that
/// was fired mouth down in ash. Its edge is soft, and wanders as a fire does. A stand-in: no fire
/// is computed.
struct SmokeDef {
  int seed = 1;           ///< Of the wandering, 0..1000000.
  int turn = 0;           ///< Sectors by which the edge is turned, 0..kSectors - 1.
  double from = 0.0;      ///< Middle of the edge, m along the outline, 0..2.1.
  double soft = 0.012;    ///< From clear to black, m, 0.001..0.05; 0.005..0.025 is usual.
  double wander = 0.010;  ///< Up and down, m, 0..0.05; 0.005..0.02 is usual.
  double carbon = 1.0;    ///< Of the black, 0..1.

  static constexpr const char* kName = "smoke";
  static std::span<const DefField<SmokeDef, int>> counts();
  static std::span<const DefField<SmokeDef>> fields();
};

/// Smokes the pot; what was darker stays. `def` is valid (laws.h).
Work smoke(Surface& surface, const SmokeDef& def);

}  // namespace onggi::surface
