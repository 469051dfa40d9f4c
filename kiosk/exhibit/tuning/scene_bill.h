#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"
#include "kiosk/ground/files/json.h"

namespace onggi::tuning {

/// The cost and the influence of one effect of a scene, or of one option of an effect: the scene
/// with it against the scene without it and everything that needs it. Shape and force are the
/// largest of three pieces of work: a finger, both hands, a palm or sponge.
struct BillLine {
  std::string effect;         ///< "walls"; for an option its key in the scene: "bending_strength".
  std::string part_of;        ///< The effect whose row contains this one; empty: a row of its own.
  double us = 0.0;            ///< Of a tick's median; noise may make it negative.
  double shape_mm = 0.0;      ///< Root mean square of the outlines' difference.
  double shape_max_mm = 0.0;  ///< At the worst place.
  double force_n = 0.0;       ///< Root mean square of the hand's force, N.
};
/// The costs of a scene.
struct SceneBill {
  std::string scene, machine, command;
  int rows = 0, sectors = 0;
  double contact_us = 0.0, whole_us = 0.0;  ///< Without any effect, and with all.
  std::vector<BillLine> lines;              ///< Most expensive first, each followed by its options.
  /// Effects that the scene lacks: what each would add, with what it needs, at its defaults.
  std::vector<BillLine> offers;
};

/// Measured on a wall of 10 mm, wetted for the first half, on the scene's own grid; time with both
/// hands, measured `passes` times (at least once), each tick with its shortest time. The kiln is
/// not part of the tick. `with_offers`: `offers` too. Seconds of work. Problem if the scene is
/// invalid, or runs on the printed model, which has no effects.
Result<SceneBill> bill_of(const std::string& name, const SceneDef& def, int passes,
                          bool with_offers = false);

/// Why its times cannot be believed: the scene without an effect took clearly longer than with it.
/// Whole sentences; empty if nothing speaks against them.
std::string doubt_of(const SceneBill& bill);

files::Json json_of(const SceneBill& bill);
std::string text_of(const SceneBill& bill);

}  // namespace onggi::tuning
