#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

#include "engine/base/result.h"
#include "engine/scene/scene_def.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

struct TouchToSoundPlan {
  SceneDef scene;
  double seconds = 60.0;   ///< 1 to 86400.
  std::uint64_t seed = 1;  ///< Of when the finger comes and goes.
};

/// How soon a touch is heard, and whether the sound card ever ran dry, beside the running 1 kHz
/// loop.
struct TouchToSound {
  std::string machine, card;
  std::uint64_t seed = 1;
  double seconds = 0.0;
  int touches = 0;  ///< That were heard.
  int unheard = 0;  ///< Over before a block was asked for.
  /// ms from the tick in which clay was touched to its block coming out.
  double median_ms = 0.0, p99_ms = 0.0, worst_ms = 0.0;
  std::uint64_t blocks = 0, dry = 0;  ///< sound::Speaker::Status::late.
  double worst_gap_ms = 0.0;
  std::uint64_t late_ticks = 0;  ///< Of the loop, over 0.5 ms.
};

/// A finger comes to the wall and goes, five times a second by chance, while the scene runs.
/// Problem where there is no sound card. Says on `progress` how far it is. Blocks for `seconds`.
Result<TouchToSound> touch_to_sound(const TouchToSoundPlan& plan, std::FILE* progress);

files::Json json_of(const TouchToSound& heard);
std::string text_of(const TouchToSound& heard);

}  // namespace onggi::measure
