#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace onggi::watch {

/// How the last runs of the exhibit ended, in a file that outlasts a crash and a power cut. It goes
/// by the order of runs and by how long they lasted, and never by the wall clock, which may be
/// years off after a flat battery.
class RunLedger {
 public:
  /// So many runs in a row that ended by a crash, none of them over kSteady seconds long, are no
  /// accident: the exhibit is at fault.
  static constexpr int kMostCrashes = 4;
  static constexpr double kSteady = 150.0;

  /// In `folder`, which is made where it is not there. A file that is missing or damaged begins
  /// anew: play matters more than its past.
  explicit RunLedger(std::filesystem::path folder);

  /// This run begins. One before it that did not say ended() is a crash. Problem (exit 1) where the
  /// disk refuses; the count is right all the same.
  Result<void> begin();
  /// It has gone on for `seconds`; past kSteady the crashes before it are forgotten. Writes once.
  Result<void> lasted(double seconds);
  /// It ends because it was asked to.
  Result<void> ended();

  /// Crashes in a row before this run.
  int crashes() const { return crashes_; }
  /// This run is to show an exhibit that is known to be good.
  bool safe() const { return crashes_ >= kMostCrashes; }

 private:
  Result<void> write(bool running, int crashes);
  std::filesystem::path file_;
  int crashes_ = 0;
  bool steady_ = false;
};

}  // namespace onggi::watch
