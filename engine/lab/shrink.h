#pragma once

#include <cstdint>
#include <vector>

#include "engine/lab/trial_run.h"

namespace onggi::lab {

/// Slightly simpler trials, the boldest cuts first: fewer strokes, fewer ticks, one hand, fewer
/// effects, default numbers. Each is a scene that validate() accepts. Allocates.
std::vector<Trial> simpler(const Trial& trial);

/// The smallest trial found.
struct Shrunk {
  Trial trial;
  Breach breach;
  std::uint64_t ticks = 0;  ///< Ticks that the search ran.
};

/// The smallest trial that still breaks the same invariant: takes the first simpler one that does,
/// until none is left or `most_ticks` have been run. `breach`: of `trial`.
Shrunk least_of(Trial trial, const Breach& breach, const TrialChecks& checks,
                std::uint64_t most_ticks);

}  // namespace onggi::lab
