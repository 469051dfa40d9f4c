#include "kiosk/exhibit/tuning/scene_bench.h"

#include <algorithm>

#include "kiosk/exhibit/tuning/machine.h"

namespace onggi::tuning {
namespace {

double mean_force(const lab::SceneOutcome& outcome) {
  double sum = 0.0;
  long count = 0;
  for (const Vec3& force : outcome.force) {
    if (length(force) < 1e-6) continue;
    sum += length(force);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace

Result<SceneBench> SceneBench::create(const std::string& name, const SceneDef& def, int rows,
                                      double tick) {
  SceneBench bench;
  for (lab::SceneWork& work : lab::scene_works(name, def)) {
    auto truth = lab::outcome_of(work, tick, rows);
    if (!truth) return tl::unexpected(truth.error());
    bench.works_.push_back({std::move(work), std::move(*truth)});
  }
  return bench;
}

Result<std::vector<lab::AccuracyRow>> SceneBench::rows(std::array<int, 2> grid, int passes) const {
  std::vector<lab::AccuracyRow> all;
  for (const Known& known : works_) {
    lab::SceneWork work = known.work;
    work.def.clay.rows = grid[0];
    work.def.clay.sectors = grid[1];
    lab::AccuracyRow row;
    row.script = work.name;
    row.setting.rows = grid[0];
    row.setting.sectors = grid[1];
    std::vector<double> least;
    for (int pass = 0; pass < passes; ++pass) {
      auto outcome = lab::outcome_of(work, 1e-3, grid[0], thread_us);
      if (!outcome) return tl::unexpected(outcome.error());
      if (pass == 0) {
        const lab::Apart off = lab::apart(*outcome, known.truth);
        row.errors = {off.shape, off.shape_max, off.force,
                      lab::volume_apart(*outcome, known.truth, work.def.clay)};
        row.mean_force = mean_force(*outcome);
        row.true_force = mean_force(known.truth);
        least = std::move(outcome->tick_us);
        continue;
      }
      for (std::size_t n = 0; n < std::min(least.size(), outcome->tick_us.size()); ++n)
        least[n] = std::min(least[n], outcome->tick_us[n]);
    }
    row.p50 = lab::percentile(least, 0.5);
    row.p999 = lab::percentile(least, 0.999);
    row.worst = lab::percentile(std::move(least), 1.0);
    all.push_back(std::move(row));
  }
  return all;
}

}  // namespace onggi::tuning
