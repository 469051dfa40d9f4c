#pragma once

#include <array>
#include <string>
#include <vector>

#include "engine/lab/accuracy.h"
#include "engine/lab/scene_work.h"

namespace onggi::tuning {

/// A visitor's scene on any grid, against its own finest self: a finger and both hands on its wall
/// (lab::scene_works). What no second program can work, since it has effects, is compared with
/// itself.
class SceneBench {
 public:
  /// Works the scene on `rows` rows with ticks of `tick` s: seconds of work. Problem where it is
  /// none.
  static Result<SceneBench> create(const std::string& name, const SceneDef& def, int rows,
                                   double tick);
  /// A row for each work at 1 kHz on `grid` (rows, sectors), timed `passes` times (at least once):
  /// of each tick the least counts.
  Result<std::vector<lab::AccuracyRow>> rows(std::array<int, 2> grid, int passes) const;

 private:
  struct Known {
    lab::SceneWork work;
    lab::SceneOutcome truth;
  };
  std::vector<Known> works_;
};

}  // namespace onggi::tuning
