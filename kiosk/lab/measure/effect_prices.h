#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/scene/scene_def.h"

namespace onggi::measure {

/// A scene of the price list: what it is called, and what it has.
struct PricedScene {
  std::string name;  ///< "base", "+ slump", "studio.toml", "all"
  SceneDef def;
};

/// What a tick of it costs, over the script "pull_tall". It is played several times, every time the
/// same to the bit, and of each tick the least of its times counts: what the machine did besides is
/// not in it, and a slow tick is.
struct EffectPrice {
  std::string name;
  double median_ns = 0.0, p999_ns = 0.0;  ///< Of ticks in which a hand pressed clay; the
                                          ///< thread's own time, less the clock's.
  double asleep_ns = 0.0;                 ///< Median of ticks at the end, when nothing moves.
  std::int64_t bytes = 0;                 ///< What the heap holds of it, less what base does.
  /// What it changes of what one hand leaves and feels on a wall in the base scene: root mean
  /// square of the outline, m, the most of it, and of the force, N. NaN of the printed model, which
  /// has no wall.
  double shape = 0.0, shape_max = 0.0, force = 0.0;
  std::int64_t instructions = 0;  ///< A tick, mean of 200 in contact; 0: not counted.
};

/// base (no effect), base and each effect with what it needs, and base with all of them, each on
/// the default lump on `rows` x `sectors`. base is the first.
std::vector<PricedScene> priced_scenes(int rows, int sectors);

/// Plays the script on it, `passes` times (at least one). Not for the 1 kHz thread. Problem where
/// the scene is none, or too little was touched to say.
Result<EffectPrice> price_of(const PricedScene& priced, int passes);

/// Plays as far as the script's contact and then 200 ticks within a function that callgrind can
/// find: onggi_priced_ticks.
Result<void> play_priced_ticks(const PricedScene& priced);
inline constexpr int kPricedTicks = 200;

}  // namespace onggi::measure
