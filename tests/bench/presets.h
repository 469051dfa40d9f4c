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
  Times wall, cpu;    ///< Of every tick of every pass.
  Times work;         ///< Of the least of all passes of each tick, in the thread's own time: a tick
                      ///< does the same at every pass, so this is the engine's and no machine's.
  double asleep = 0;  ///< Median of the last second, ns, wall clock: hands away, wheel at rest.
};
/// Throws it `passes` times from the same lump. `most_ticks` of the script at most; 0: all.
ThrowingTimes measure_throwing(const SceneDef& def, std::string_view script, int passes,
                               int most_ticks = 0);

/// The presets' p99.9 of all scripts that they have the tools for, the slowest that is done with
/// fingers, and the slowest of all; studio's on the finest grid; and what effects cost asleep, each
/// and all of a preset.
Figures preset_tails(Effort effort);
Figures finest_studio(Effort effort);
Figures asleep(Effort effort);
/// What each tool of first_touch takes that is pushed slowly into the turning lump: median and p99
/// of the least of some passes of each tick, in the thread's own time, so of the work alone.
Figures tools_pushed(Effort effort);

}  // namespace onggi::bench
