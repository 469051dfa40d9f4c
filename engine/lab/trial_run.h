#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/lab/invariant_checker.h"
#include "engine/lab/trial.h"

namespace onggi::lab {

/// How closely a trial is looked at.
struct TrialChecks {
  bool twice = false;   ///< Once more, with other vectors: the same hash.
  bool mirror = false;  ///< Once more in a mirror: the mirrored pot.
  std::function<bool()>
      give_up{};  ///< Asked now and then; true ends the trial, and nothing is found.
};

/// What a trial came to.
struct TrialResult {
  std::optional<Breach> breach;  ///< The first.
  std::uint64_t ticks = 0;       ///< Of all runs.
  std::uint64_t touched = 0;     ///< Elements pressed in the first.
  std::uint64_t hash = 0;        ///< State at its end, where it was run `twice`.
};

/// Runs it on scenes of its own. A trial whose scene validate() refuses comes to nothing.
/// Allocates; a thread may run its own trials beside others.
TrialResult run_trial(const Trial& trial, const TrialChecks& checks = {});

/// How far two pots are from being each other's mirror image, m: the widest difference of two
/// elements' faces, or of two rows' heights.
double mirror_difference(const Clay& clay, const Clay& image);
/// What a mirror may be off by, m: roundings differ, and what lies at the edge of a press then is
/// in or out of it.
inline constexpr double kMirrorAllowed = 2e-5;

}  // namespace onggi::lab
