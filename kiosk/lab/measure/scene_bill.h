#pragma once

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"
#include "kiosk/ground/files/json.h"
#include "kiosk/picture/drawing/bill_sheet.h"

namespace onggi::measure {

/// What one effect of a scene, or one of the things that an effect is asked for besides, costs and
/// changes: the scene with it against the scene without it and without what needs it. Shape and
/// force are the most of three pieces of work: a finger, both hands, a palm or sponge.
struct BillLine {
  std::string effect;         ///< "walls"; of a part its key in the scene: "yield_stress".
  std::string part_of;        ///< The effect whose row has this one in it; empty: a row of its own.
  double us = 0.0;            ///< Of a tick's median; noise may make it less than nothing.
  double shape_mm = 0.0;      ///< Root mean square of the outlines' difference.
  double shape_max_mm = 0.0;  ///< At the worst place.
  double force_n = 0.0;       ///< Root mean square of the hand's force, N.
};
/// A scene's bill.
struct SceneBill {
  std::string scene, machine, command;
  int rows = 0, sectors = 0;
  double contact_us = 0.0, whole_us = 0.0;  ///< Without any effect, and as it is.
  std::vector<BillLine> lines;              ///< Dearest first, and behind each its parts.
};

/// On a wall of 10 mm, wetted for the first half, on the scene's own grid: time with both hands;
/// timed `passes` times (at least once), of each tick the least counts. The kiln has no part in the
/// tick. Seconds of work. Problem where the scene is none, or runs on the printed model, which has
/// no effect.
Result<SceneBill> bill_of(const std::string& name, const SceneDef& def, int passes);

files::Json json_of(const SceneBill& bill);
std::string text_of(const SceneBill& bill);
drawing::BillSheet sheet_of(const SceneBill& bill);

}  // namespace onggi::measure
