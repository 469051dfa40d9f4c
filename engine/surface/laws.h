#pragma once

#include <variant>
#include <vector>

#include "engine/surface/brush.h"
#include "engine/surface/burnish.h"
#include "engine/surface/coil.h"
#include "engine/surface/cut.h"
#include "engine/surface/dip.h"
#include "engine/surface/fill.h"
#include "engine/surface/resist.h"
#include "engine/surface/scrape.h"
#include "engine/surface/smoke.h"
#include "engine/surface/stamp.h"
#include "engine/surface/wipe.h"

namespace onggi::surface {

/// One per law.
using Tool = std::variant<CutDef, BrushDef, ScrapeDef, WipeDef, StampDef, DipDef, ResistDef,
                          BurnishDef, SmokeDef, FillDef, CoilDef>;

/// Everything that a hand did to a surface at once: the same strokes leave the same surface.
struct Stroke {
  Tool tool;
  std::vector<Station> stations;  ///< None for a dip and for smoke.
  bool continues = false;         ///< Taken back together with the stroke before.
};

inline constexpr std::size_t kMostStations = 1u << 20;
inline constexpr int kLongestStep = 4000;  ///< From a station to the next, um.
inline constexpr int kMostTurns = 1000;

/// Checks a stroke for `surface`; the first fault with its place.
Result<void> validate(const Surface& surface, const Stroke& stroke);

/// Does a stroke as one step of the undo. A stroke that is not valid does nothing.
Result<Work> apply(Surface& surface, const Stroke& stroke);

/// The same stroke `sectors` further round.
Stroke turned(Stroke stroke, int sectors);

/// `stroke` at `n` places round the pot, to be taken back together. Problem unless n divides
/// kSectors.
Result<std::vector<Stroke>> repeated(const Stroke& stroke, int n);

}  // namespace onggi::surface
