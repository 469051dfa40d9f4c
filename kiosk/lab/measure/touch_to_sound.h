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
  std::uint64_t seed = 1;  ///< Seed of the finger's timing.
};

/// The delay from a touch to its sound, and whether the sound card ran dry, beside the running 1
/// kHz loop.
struct TouchToSound {
  std::string machine, card;
  std::uint64_t seed = 1;
  double seconds = 0.0;
  int touches = 0;  ///< Number of heard touches.
  int unheard = 0;  ///< Ended before a block was requested.
  /// ms from the tick in which clay was touched to its block coming out.
  double median_ms = 0.0, p99_ms = 0.0, worst_ms = 0.0;
  std::uint64_t blocks = 0, dry = 0;  ///< sound::Speaker::Status::late.
  double worst_gap_ms = 0.0;
  std::uint64_t late_ticks = 0;  ///< Of the loop, over 0.5 ms.
};

/// A finger touches the wall and leaves, about five times a second at random, while the scene runs.
/// Problem if there is no sound card. Prints progress to `progress`. Blocks for `seconds`.
Result<TouchToSound> touch_to_sound(const TouchToSoundPlan& plan, std::FILE* progress);

files::Json json_of(const TouchToSound& heard);
std::string text_of(const TouchToSound& heard);

}  // namespace onggi::measure
