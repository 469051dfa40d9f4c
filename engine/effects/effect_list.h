#pragma once

#include <optional>

#include "engine/effects/beating.h"
#include "engine/effects/building.h"
#include "engine/effects/friction.h"
#include "engine/effects/kiln.h"
#include "engine/effects/moisture.h"
#include "engine/effects/prints.h"
#include "engine/effects/propagation.h"
#include "engine/effects/slump.h"
#include "engine/effects/smoothing.h"
#include "engine/effects/springback.h"
#include "engine/effects/tearing.h"
#include "engine/effects/volume.h"
#include "engine/effects/walls.h"
#include "engine/effects/wobble.h"

namespace onggi {

/// The effects of a scene (engine/docs/effects.md). A present effect is simulated; an absent one
/// costs no byte and no instruction. To add one, write its pair of files and add a word to each
/// list of this file.
struct Effects {
  std::optional<MoistureDef> moisture = MoistureDef{};
  std::optional<WallsDef> walls;
  std::optional<PropagationDef> propagation;
  std::optional<SpringbackDef> springback;
  std::optional<SmoothingDef> smoothing;
  std::optional<WobbleDef> wobble;
  std::optional<SlumpDef> slump;  ///< Needs volume.
  std::optional<VolumeDef> volume;
  std::optional<BuildingDef> building;  ///< Needs volume.
  std::optional<BeatingDef> beating;    ///< Needs volume.
  std::optional<PrintsDef> prints;      ///< Needs beating.
  std::optional<FrictionDef> friction = FrictionDef{};
  std::optional<KilnDef> kiln;  ///< At the visit's end; not a stage of the tick.
};

/// Calls `visit` with every effect of `def`, a std::optional<XDef>. `def` is a SceneDef, const or
/// not.
template <class AnyEffects, class Visit>
void each_effect(AnyEffects& def, Visit&& visit) {
  visit(def.moisture);
  visit(def.walls);
  visit(def.propagation);
  visit(def.springback);
  visit(def.smoothing);
  visit(def.wobble);
  visit(def.slump);
  visit(def.volume);
  visit(def.building);
  visit(def.beating);
  visit(def.prints);
  visit(def.friction);
  visit(def.kiln);
}

namespace effects {

/// The effects that work on rows, in the pipeline's order: 6.1 to 6.10.
using RowStages = Stages<Propagation, Springback, Smoothing, Wobble, Slump, Tearing, Volume,
                         Building, Beating, Prints>;

}  // namespace effects
}  // namespace onggi
