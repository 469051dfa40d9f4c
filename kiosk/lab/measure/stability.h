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

/// A night of random trials.
struct StabilityPlan {
  double ticks = 1e9;                                    ///< To have been run in all, 1..1e15.
  std::uint64_t seed = 1;                                ///< Trial n is drawn from seed and n.
  int threads = 0;                                       ///< 0: as many as there are cores.
  std::filesystem::path folder = "keepsakes/stability";  ///< Progress and replays.
};

/// What a trial broke.
struct StabilityFind {
  std::uint64_t trial = 0;  ///< Its number.
  std::string invariant, what;
  std::string replay;  ///< File that `onggi replay` opens: the least that still breaks it.
};

/// What came of it, those runs before among it that were interrupted.
struct StabilityTally {
  std::uint64_t seed = 0;
  std::uint64_t trials = 0;  ///< All with a smaller number are done.
  std::uint64_t ticks = 0;   ///< That those were.
  std::vector<StabilityFind> finds;
  bool interrupted = false;
};

/// Trials are of this many ticks, about; every one is run twice.
inline constexpr int kTrialTicks = 4000;
/// So many finds end the run.
inline constexpr std::size_t kMostFinds = 20;

/// Runs trials on all cores until there are `plan.ticks`, or until SIGINT or SIGTERM; goes on where
/// a run of the same seed was interrupted, by what it keeps in the folder every ten seconds. Tells
/// every ten seconds on `told`. Problem where the folder cannot be written, or its progress is of
/// another generator of trials. Main thread; blocks.
Result<StabilityTally> measure_stability(const StabilityPlan& plan, std::FILE* told);

/// Does a replay again and looks at every tick. Problem (exit 1) where something does not hold.
Result<std::string> check_replay(const Replay& replay);

/// Runs trial `number` of `plan.seed` and no other; what it breaks is made small and kept in the
/// folder. No progress is read or kept, and `plan.ticks` and `plan.threads` do not matter. The
/// tally is of this trial alone. Problem where the replay cannot be kept. Main thread; blocks,
/// until SIGINT or SIGTERM at the latest.
Result<StabilityTally> measure_trial(const StabilityPlan& plan, std::uint64_t number);

files::Json json_of(const StabilityTally& tally);

/// The progress file's text, and what such a text says; Problem with `name` where it makes no
/// sense.
std::string text_of(const StabilityTally& tally);
Result<StabilityTally> read_tally(const std::string& text, const std::string& name);

}  // namespace onggi::measure
