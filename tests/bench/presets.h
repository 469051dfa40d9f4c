#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene_def.h"
#include "tests/bench/goals.h"
#include "tests/bench/timing.h"

namespace onggi::bench {

/// A scene of config/scenes that visitors throw in.
struct Preset {
  std::string name;  ///< "studio"
  SceneDef def;      ///< On the grid asked for.
};
/// first_touch, studio and master of config/scenes below the working directory. Ends the program
/// where one cannot be read.
std::vector<Preset> presets(int rows, int sectors);

/// A script for an effect (engine/script/demonstrations.h), thrown in a preset.
struct ThrowingTimes {
  Times wall, cpu;    ///< Of each tick's least time over the passes.
  double asleep = 0;  ///< Median of the last second, ns, wall clock: hands away, wheel at rest.
  int ticks = 0;
};
/// Throws it `passes` times from the same lump. Every pass does the same work to the bit, so what a
/// tick takes is the least of its times: what the machine did besides falls out, a slow tick does
/// not. `most_ticks` of the script at most; 0: all.
ThrowingTimes measure_throwing(const SceneDef& def, std::string_view script, int passes,
                               int most_ticks = 0);

/// The presets' p99.9 of all scripts that they have the tools for, and the slowest that is done
/// with fingers; studio's on the finest grid; and what effects cost asleep, each and all of a
/// preset.
Figures preset_tails(Effort effort);
Figures finest_studio(Effort effort);
Figures asleep(Effort effort);

}  // namespace onggi::bench
