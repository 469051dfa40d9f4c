#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "engine/lab/invariant_checker.h"
#include "engine/lab/trial.h"

namespace onggi::lab {

/// How closely a trial is checked.
struct TrialChecks {
  bool twice = false;               ///< Runs it again, with other vectors: the same hash.
  bool mirror = false;              ///< Runs it again in a mirror: the mirrored pot.
  std::function<bool()> give_up{};  ///< Called now and then; true ends the trial without a finding.
};

/// The result of a trial.
struct TrialResult {
  std::optional<Breach> breach;  ///< The first.
  std::uint64_t ticks = 0;       ///< Of all runs.
  std::uint64_t touched = 0;     ///< Elements pressed in the first.
  std::uint64_t hash = 0;        ///< State at its end, where it was run `twice`.
};

/// Runs the trial on scenes of its own. Does nothing if validate() refuses the scene. Allocates;
/// threads may run trials beside each other.
TrialResult run_trial(const Trial& trial, const TrialChecks& checks = {});

/// How far two pots are from being mirror images, m: the largest difference of two elements' faces,
/// or of two rows' heights.
double mirror_difference(const Clay& clay, const Clay& image);
/// Tolerance of the mirror test, m: rounding decides whether an element at a press's edge is in it.
inline constexpr double kMirrorAllowed = 2e-5;

}  // namespace onggi::lab
