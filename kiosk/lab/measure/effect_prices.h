#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"

namespace onggi::measure {

/// A scene of the cost table: its name and its effects.
struct PricedScene {
  std::string name;  ///< "base", "+ slump", "studio.toml", "all"
  SceneDef def;
};

/// The cost of its ticks over the script "pull_tall". The script is played several times, identical
/// to the bit, and each tick counts with its shortest time, so that other work of the machine does
/// not count but a slow tick does.
struct EffectPrice {
  std::string name;
  double median_ns = 0.0, p999_ns = 0.0;  ///< Of ticks in which a hand pressed clay; the
                                          ///< thread's own time, less the clock's.
  double asleep_ns = 0.0;                 ///< Median of the last ticks, when nothing moves.
  std::int64_t bytes = 0;                 ///< Its heap memory, minus base's.
  /// How much it changes the shape and the force of one hand on a wall, relative to the base scene:
  /// root mean square of the outline, m, the largest one, and of the force, N. NaN for the printed
  /// model, which has no wall.
  double shape = 0.0, shape_max = 0.0, force = 0.0;
  std::int64_t instructions = 0;  ///< For a tick, mean of 200 in contact; 0: not counted.
};

/// base (no effect), base with each effect and its requirements, and base with all of them, each on
/// the default lump on `rows` x `sectors`. base is the first.
std::vector<PricedScene> priced_scenes(int rows, int sectors);

/// Plays the script on it, `passes` times (at least one). Not for the 1 kHz thread. Problem if the
/// scene is invalid, or if too little contact was made.
Result<EffectPrice> price_of(const PricedScene& priced, int passes);

/// Plays up to the script's contact, then 200 ticks inside a function that callgrind can find:
/// onggi_priced_ticks.
Result<void> play_priced_ticks(const PricedScene& priced);
inline constexpr int kPricedTicks = 200;

}  // namespace onggi::measure
