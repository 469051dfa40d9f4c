#include "kiosk/lab/measure/accuracy_run.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>

#include "engine/lab/trial_run.h"
#include "engine/math/portable.h"
#include "kiosk/exhibit/tuning/machine.h"
#include "kiosk/exhibit/tuning/scene_bench.h"
#include "kiosk/ground/files/monotonic.h"
#include "kiosk/lab/measure/accuracy_built.h"
#include "kiosk/lab/measure/accuracy_orders.h"
#include "kiosk/lab/measure/scene_presets.h"

namespace onggi::measure {
namespace {

using Setting = lab::AccuracySetting;
using Model = Setting::Model;

// Prints its progress every two seconds.
class Teller {
 public:
  Teller(std::FILE* told, double all) : told_(told), all_(all) {}
  void done(double work, const std::string& what) {
    work_ += work;
    const double now = files::monotonic_seconds();
    if (now - last_ < 2.0) return;
    last_ = now;
    const double spent = now - start_;
    std::fprintf(told_, "%3.0f %%, about %.0f s left: %s\n", 100.0 * work_ / all_,
                 spent * (all_ - work_) / std::max(work_, 1e-9), what.c_str());
    std::fflush(told_);
  }
  double seconds() const { return files::monotonic_seconds() - start_; }

 private:
  std::FILE* told_;
  double all_, work_ = 0.0, start_ = files::monotonic_seconds(), last_ = start_;
};

// The reference of each script, and its distance from one half as fine.
struct Known {
  lab::Truth truth;
  double apart = 0.0;  // m
};

// Two at a time, because nothing is timed meanwhile.
std::vector<Known> truths_of(const std::vector<lab::AccuracyScript>& scripts,
                             const lab::TruthPlan& plan) {
  std::vector<Known> all(scripts.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t n = next++; n < scripts.size(); n = next++) {
      all[n].truth = lab::truth_of(scripts[n], plan);
      const lab::Truth half =
          lab::truth_of(scripts[n], {plan.rows / 2, plan.sectors / 2, 0.5 * plan.rate_hz});
      for (std::size_t side = 0; side < 2; ++side)
        if (half.face[side].rows > 0)
          all[n].apart =
              std::max(all[n].apart, lab::difference(half.face[side], all[n].truth.face[side]).rms);
    }
  };
  auto other = std::async(std::launch::async, work);
  work();
  other.get();
  return all;
}

// What no truth is surer of, mm.
double farthest_mm(const std::vector<Known>& truths, const std::vector<KnownBuilt>& built) {
  double most = 0.0;
  for (const Known& known : truths) most = std::max(most, 1e3 * known.apart);
  for (const KnownBuilt& known : built) most = std::max(most, 1e3 * known.apart);
  return most;
}

// What random hands break in a model on a grid, in the benchmark's own scene.
std::optional<UnstableSetting> unstable(Model model, std::array<int, 2> grid, std::uint64_t seed) {
  SceneDef def = lab::accuracy_scripts().front().def;
  def.clay.rows = grid[0];
  def.clay.sectors = grid[1];
  if (model == Model::printed) def.paper.emplace();
  constexpr std::uint64_t kTrials = 3;
  for (std::uint64_t n = 0; n < kTrials; ++n) {
    const lab::Trial trial =
        lab::random_hands(def, seed + n, {.ticks = 600, .strokes = 12, .nonsense = true});
    if (const auto found = lab::run_trial(trial); found.breach)
      return UnstableSetting{
          model, grid[0], grid[1],
          lab::name_of(found.breach->invariant) + std::string(": ") + found.breach->what};
  }
  return std::nullopt;
}

// The half of a surface that faces the reader, and its error.
AccuracyPot pot_of(const lab::AccuracyScript& vase, const lab::FaceGrid& truth,
                   const Setting& setting) {
  const lab::FaceGrid face = lab::face_left(vase, setting, WallSide::outside);
  AccuracyPot pot;
  pot.setting = setting;
  pot.columns = 180;
  pot.rows = 240;
  pot.low = vase.balls[0].from - 0.004;
  pot.high = vase.balls[0].to + 0.004;
  for (int j = 0; j < pot.rows; ++j)
    for (int i = 0; i < pot.columns; ++i) {
      const double height = pot.low + (pot.high - pot.low) * j / (pot.rows - 1);
      const double angle = portable::kPi * (i + 0.5) / pot.columns;
      const double radius = lab::radius_at(face, height, angle);
      pot.radius.push_back(static_cast<float>(radius));
      pot.off.push_back(
          static_cast<float>(std::fabs(radius - lab::radius_at(truth, height, angle))));
    }
  return pot;
}

std::vector<UnstableSetting> all_unstable(const AccuracyPlan& plan) {
  std::vector<UnstableSetting> all;
  for (const Model model : {Model::shipped, Model::printed})
    for (const auto& grid : plan.grids())
      if (grid[0] <= (model == Model::printed || !plan.quick ? 1600 : 800))
        if (auto found = unstable(model, grid, plan.seed)) all.push_back(std::move(*found));
  return all;
}

std::vector<AccuracyPot> all_pots(const AccuracyPlan& plan, const lab::AccuracyScript& vase,
                                  const lab::FaceGrid& truth) {
  std::vector<AccuracyPot> all;
  for (const Model model : {Model::shipped, Model::printed})
    for (const auto& grid : plan.grids()) {
      if (grid[0] > 1600 || (model == Model::printed && grid != AccuracyPlan::kUsual)) continue;
      Setting setting;
      setting.model = model;
      setting.rows = grid[0];
      setting.sectors = grid[1];
      all.push_back(pot_of(vase, truth, setting));
    }
  return all;
}

void sum_up(AccuracyReport& report, const std::vector<lab::AccuracyScript>& scripts) {
  std::vector<lab::AccuracyRow> of_scripts = report.rows;
  std::erase_if(of_scripts, [&](const lab::AccuracyRow& row) {
    return std::ranges::none_of(scripts, [&](const auto& one) { return one.name == row.script; });
  });
  report.settings = lab::summaries(of_scripts);
  report.edge = lab::pareto_edge(report.settings);
  report.scenes = lab::summaries(without_built(report.rows));
  report.recommended = lab::recommend(report.scenes, 1000.0, report.thresholds);
}

}  // namespace

Result<AccuracyReport> measure_accuracy(const AccuracyPlan& plan, std::FILE* told) {
  AccuracyReport report;
  report.plan = plan;
  report.machine = tuning::machine_name();
  auto scenes = read_presets();
  if (!scenes) return tl::unexpected(scenes.error());
  // The printed model is already in every script, without its filter.
  std::erase_if(*scenes, [](const ScenePreset& one) { return one.def.paper.has_value(); });
  const std::vector<lab::AccuracyScript> scripts = lab::accuracy_scripts();
  const std::vector<Setting> settings = plan.settings();
  const double truth_work = plan.quick ? 8.0 : 45.0, suite_work = 1.5, preset_work = 1.5;
  double all = truth_work + suite_work + preset_work * static_cast<double>(scenes->size());
  for (const lab::AccuracyScript& script : scripts)
    for (const Setting& setting : settings)
      if (lab::can_work(script, setting)) all += work_of(script, setting, plan.passes(setting));
  for (const lab::BuiltScript& script : lab::built_scripts())
    for (const Setting& setting : built_settings(plan, script))
      all += work_of(script, setting, plan.passes(setting));
  Teller teller(told, all);
  const std::vector<Known> truths = truths_of(scripts, plan.truth());
  const std::vector<KnownBuilt> built = built_truths(plan);
  report.truth_mm = farthest_mm(truths, built);
  teller.done(truth_work, "what is true of each script");

  for (std::size_t n = 0; n < scripts.size(); ++n)
    for (const Setting& setting : settings) {
      if (!lab::can_work(scripts[n], setting)) continue;
      const int passes = plan.passes(setting);
      report.rows.push_back(
          lab::measure_accuracy(scripts[n], truths[n].truth, setting, tuning::thread_us, passes));
      teller.done(work_of(scripts[n], setting, passes),
                  scripts[n].name + ", " + lab::name_of(setting.model) + " on " +
                      std::to_string(setting.rows) + " x " + std::to_string(setting.sectors));
    }
  for (const KnownBuilt& known : built)
    for (const Setting& setting : built_settings(plan, known.script)) {
      const int passes = plan.passes(setting);
      report.rows.push_back(
          lab::measure_built(known.script, known.truth, setting, tuning::thread_us, passes));
      teller.done(work_of(known.script, setting, passes), known.script.name + " on " +
                                                              std::to_string(setting.rows) + " x " +
                                                              std::to_string(setting.sectors));
    }
  for (const ScenePreset& preset : *scenes) {
    const auto bench = tuning::SceneBench::create(preset.name, preset.def, plan.preset_truth_rows(),
                                                  plan.preset_truth_tick());
    if (!bench) return tl::unexpected(bench.error());
    for (const auto& grid : plan.preset_grids()) {
      const auto rows = bench->rows(grid, 5);
      if (!rows) return tl::unexpected(rows.error());
      report.rows.insert(report.rows.end(), rows->begin(), rows->end());
    }
    teller.done(preset_work, preset.name);
  }
  report.unstable = all_unstable(plan);
  teller.done(suite_work, "random hands");

  sum_up(report, scripts);
  report.orders = orders_of(report.rows);
  for (const lab::AccuracyScript& script : scripts)
    for (const lab::TimeRule rule :
         {lab::TimeRule::shipped, lab::TimeRule::exact, lab::TimeRule::printed}) {
      Setting law;
      law.model = Model::plain;
      law.rule = rule;
      const auto found = tick_orders(script, law, AccuracyPlan::kRates);
      report.orders.insert(report.orders.end(), found.begin(), found.end());
    }
  report.pots = all_pots(plan, scripts.back(), truths.back().truth.face[0]);
  report.seconds = teller.seconds();
  return report;
}

AccuracyReport report_again(AccuracyReport before, std::FILE* told) {
  const std::vector<lab::AccuracyScript> scripts = lab::accuracy_scripts();
  Teller teller(told, 3.0);
  const std::vector<Known> truths = truths_of(scripts, before.plan.truth());
  before.truth_mm = farthest_mm(truths, built_truths(before.plan));
  teller.done(1.0, "what is true of each script");
  before.unstable = all_unstable(before.plan);
  teller.done(1.0, "random hands");
  before.pots = all_pots(before.plan, scripts.back(), truths.back().truth.face[0]);
  sum_up(before, scripts);
  return before;
}

}  // namespace onggi::measure
