#include "kiosk/exhibit/tuning/tuner.h"

#include <algorithm>
#include <cstdio>

#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/exhibit/tuning/scene_bench.h"

namespace onggi::tuning {
namespace {

// A light press, two hands, and a deep fast throw, which needs the finest grid.
constexpr std::array<const char*, 3> kScripts{"press", "collar", "throw"};

// Whatever a grid is measured by.
class Benches {
 public:
  static Result<Benches> create(const std::string& name, const SceneDef& def,
                                const TunePlan& plan) {
    if (def.paper)
      return problem(name, "This scene runs on the printed model, whose grid is part of it.",
                     "Remove [paper], or leave the grid as it is.");
    Benches all(plan);
    for (lab::AccuracyScript& script : lab::accuracy_scripts()) {
      if (std::find(kScripts.begin(), kScripts.end(), script.name) == kScripts.end()) continue;
      if (all.given_up()) return all.gave_up(name);
      script.def.contact = def.contact;
      lab::Truth truth = lab::truth_of(script, plan.truth);
      all.scripts_.push_back({std::move(script), std::move(truth)});
    }
    if (all.given_up()) return all.gave_up(name);
    auto scene = SceneBench::create(name, def, plan.scene_rows, 5e-4);
    if (!scene) return tl::unexpected(scene.error());
    all.scene_ = std::move(*scene);
    return all;
  }

  Result<lab::SettingSummary> worst_on(std::array<int, 2> grid) const {
    lab::AccuracySetting setting;
    setting.rows = grid[0];
    setting.sectors = grid[1];
    std::vector<lab::AccuracyRow> rows;
    for (const Known& known : scripts_) {
      if (given_up()) return gave_up(known.script.name);
      rows.push_back(
          lab::measure_accuracy(known.script, known.truth, setting, thread_us, plan_.passes));
    }
    auto own = scene_.rows(grid, plan_.passes);
    if (!own) return tl::unexpected(own.error());
    rows.insert(rows.end(), own->begin(), own->end());
    return lab::summaries(rows).front();
  }

 private:
  struct Known {
    lab::AccuracyScript script;
    lab::Truth truth;
  };
  explicit Benches(const TunePlan& plan) : plan_(plan) {}
  bool given_up() const { return plan_.give_up && plan_.give_up(); }
  static tl::unexpected<Problem> gave_up(const std::string& name) {
    return problem(name, "The search for a grid was interrupted.", "Let it finish next time.", 1);
  }

  TunePlan plan_;
  std::vector<Known> scripts_;
  SceneBench scene_;
};

TunedGrid grid_of(const lab::Recommendation& found, double error_margin, double time_margin) {
  const lab::SettingSummary& one = found.chosen;
  TunedGrid grid;
  grid.rows = one.setting.rows;
  grid.sectors = one.setting.sectors;
  grid.shape_mm = 1e3 * error_margin * one.errors.shape_rms;
  grid.worst_mm = 1e3 * error_margin * one.errors.shape_max;
  grid.force_pct = 1e2 * error_margin * one.force_share;
  grid.tick_pct = 1e2 * time_margin * one.share();
  grid.fine_enough = found.fine_enough;
  grid.in_time = found.in_time;
  return grid;
}

}  // namespace

Result<TunedGrid> tune(const std::string& name, const SceneDef& def, const TunePlan& plan) {
  const auto benches = Benches::create(name, def, plan);
  if (!benches) return tl::unexpected(benches.error());
  std::vector<lab::SettingSummary> all;
  for (const auto& grid : plan.grids) {
    auto worst = benches->worst_on(grid);
    if (!worst) return tl::unexpected(worst.error());
    all.push_back(*worst);
    if (worst->share() > 2.0 * lab::kTickBudget) break;
  }
  const auto found = lab::recommend(all, 1000.0);
  if (!found) return problem(name, "There is no grid to choose from.", "Name at least one to try.");
  return grid_of(*found, kErrorMargin, kTimeMargin);
}

Result<TunedGrid> measure_grid(const std::string& name, const SceneDef& def, const TunePlan& plan) {
  const auto benches = Benches::create(name, def, plan);
  if (!benches) return tl::unexpected(benches.error());
  const auto worst = benches->worst_on({def.clay.rows, def.clay.sectors});
  if (!worst) return tl::unexpected(worst.error());
  return grid_of(*lab::recommend({*worst}, 1000.0), 1.0, 1.0);
}

std::string words_of(const TunedGrid& grid) {
  char text[320];
  std::snprintf(
      text, sizeof text,
      "%d rows x %d sectors: at most %.3f mm off in the mean and %.2f mm at the worst "
      "place, the force at most %.1f %%; 999 of 1000 ticks take at most %.1f %% of their "
      "time.%s",
      grid.rows, grid.sectors, grid.shape_mm, grid.worst_mm, grid.force_pct, grid.tick_pct,
      !grid.in_time       ? " This machine is too slow for every grid that was tried."
      : !grid.fine_enough ? " A finer one would feel or look better, but it is too slow here."
                          : "");
  return text;
}

}  // namespace onggi::tuning
