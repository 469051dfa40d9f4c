#pragma once

#include <filesystem>

#include "engine/base/result.h"

namespace onggi::watch {

/// How the last runs of the exhibit ended, in a file that survives a crash and a power cut. It uses
/// the order and length of runs, never the wall clock, which may be years off after a flat battery.
class RunHistory {
 public:
  /// This many crashes in a row, each within kSteady seconds, mean that the exhibit is at fault.
  static constexpr int kMostCrashes = 4;
  static constexpr double kSteady = 150.0;

  /// In `folder`, which is created if missing. A missing or damaged file starts again, because
  /// running matters more than history.
  explicit RunHistory(std::filesystem::path folder);

  /// Call when this run begins. A previous run without ended() counts as a crash. Problem (exit 1)
  /// if the disk refuses; the count is still right.
  Result<void> begin();
  /// The run has lasted `seconds`; beyond kSteady, earlier crashes are cleared. Writes once.
  Result<void> lasted(double seconds);
  /// The run ends on request.
  Result<void> ended();

  /// Crashes in a row before this run.
  int crashes() const { return crashes_; }
  /// True if this run should show the last good exhibit.
  bool safe() const { return crashes_ >= kMostCrashes; }

 private:
  Result<void> write(bool running, int crashes);
  std::filesystem::path file_;
  int crashes_ = 0;
  bool steady_ = false;
};

}  // namespace onggi::watch
