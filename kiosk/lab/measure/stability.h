#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/lab/shrink.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

/// Options of a run of random trials.
struct StabilityPlan {
  double ticks = 1e9;                                    ///< Total number of ticks, 1..1e15.
  std::uint64_t seed = 1;                                ///< Trial n is generated from seed and n.
  int threads = 0;                                       ///< 0: as many as there are cores.
  std::filesystem::path folder = "keepsakes/stability";  ///< Progress and replays.
};

/// A broken invariant in a trial.
struct StabilityFind {
  std::uint64_t trial = 0;  ///< Its number.
  std::string invariant, what;
  std::string replay;  ///< File for `onggi replay`: the smallest replay that still breaks it.
};

/// The result, including earlier interrupted runs.
struct StabilityTally {
  std::uint64_t seed = 0;
  std::uint64_t trials = 0;  ///< All trials with a smaller number are done.
  std::uint64_t ticks = 0;   ///< Their ticks.
  std::vector<StabilityFind> finds;
  bool interrupted = false;
};

/// Approximate ticks of a trial; each trial is run twice.
inline constexpr int kTrialTicks = 4000;
/// This many findings end the run.
inline constexpr std::size_t kMostFinds = 20;

/// Runs trials on all cores until there are `plan.ticks`, or until SIGINT or SIGTERM; continues an
/// interrupted run of the same seed from the progress that it saves in the folder every ten
/// seconds. Reports every ten seconds to `told`. Problem if the folder cannot be written, or if its
/// progress is from another generator of trials. Main thread; blocks.
Result<StabilityTally> measure_stability(const StabilityPlan& plan, std::FILE* told);

/// Runs a replay again and checks every tick. Problem (exit 1) if an invariant is broken.
Result<std::string> check_replay(const Replay& replay);

/// Runs only trial `number` of `plan.seed`, reduces a broken replay and saves it in the folder.
/// Reads and saves no progress, and ignores `plan.ticks` and `plan.threads`. The tally covers only
/// this trial. Problem if the replay cannot be saved. Main thread; blocks, at the latest until
/// SIGINT or SIGTERM.
Result<StabilityTally> measure_trial(const StabilityPlan& plan, std::uint64_t number);

files::Json json_of(const StabilityTally& tally);

/// The text of the progress file, and its reader; Problem with `name` if the text is invalid.
std::string text_of(const StabilityTally& tally);
Result<StabilityTally> read_tally(const std::string& text, const std::string& name);

}  // namespace onggi::measure
