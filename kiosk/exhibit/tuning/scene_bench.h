#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_work.h"

namespace onggi::tuning {

/// Runs a visitor's scene on any grid and compares it with its own finest grid: a finger, and both
/// hands on its wall (lab::scene_works). A scene with effects has no independent reference, so it
/// is compared with itself.
class SceneBench {
 public:
  /// Simulates the scene on `rows` rows with ticks of `tick` s: seconds of work. Problem if it is
  /// invalid.
  static Result<SceneBench> create(const std::string& name, const SceneDef& def, int rows,
                                   double tick);
  /// A row for each work at 1 kHz on `grid` (rows, sectors), timed `passes` times (at least once);
  /// each tick counts with its shortest time.
  Result<std::vector<lab::AccuracyRow>> rows(std::array<int, 2> grid, int passes) const;

 private:
  struct Known {
    lab::SceneWork work;
    lab::SceneOutcome truth;
  };
  std::vector<Known> works_;
};

}  // namespace onggi::tuning
