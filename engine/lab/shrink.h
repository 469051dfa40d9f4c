#pragma once

#include <cstdint>
#include <vector>

#include "engine/lab/trial_run.h"

namespace onggi::lab {

/// Trials that are a little simpler than this one, the boldest cuts first: fewer strokes, fewer
/// ticks, one hand, fewer effects, numbers as they are by default. Each is a scene that validate()
/// accepts. Allocates.
std::vector<Trial> simpler(const Trial& trial);

/// What is left of a trial.
struct Shrunk {
  Trial trial;
  Breach breach;
  std::uint64_t ticks = 0;  ///< That were run to find it.
};

/// The least trial that still breaks the same invariant, by taking the first simpler one that does
/// for as long as there is one, or until `most_ticks` have been run. `breach`: of `trial`.
Shrunk least_of(Trial trial, const Breach& breach, const TrialChecks& checks,
                std::uint64_t most_ticks);

}  // namespace onggi::lab
