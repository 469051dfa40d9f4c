// What a tick costs: tests/bench/README.md. --short does a few ticks of everything.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include "tests/bench/goals.h"
#include "tests/bench/presets.h"
#include "tests/bench/timing.h"

namespace onggi::bench {
namespace {

struct Grid {
  int rows, sectors;
  Patience patience;
};
constexpr Grid kGrids[] = {
    {400, 360, {5000, 4, 0.0}}, {1600, 720, {2000, 2, 0.0}}, {6400, 2880, {1000, 2, 2.5}}};
constexpr const Grid& kFinest = kGrids[2];

// Each script is measured once, whoever asks.
const ScriptTimes& measured(const TickScript& script, const Grid& grid, Effort effort) {
  static std::map<std::pair<std::string_view, int>, ScriptTimes> all;
  const auto key = std::pair{script.name, grid.rows};
  const auto found = all.find(key);
  if (found != all.end()) return found->second;
  const Patience patience = effort.few ? Patience{12, 1, 0.0} : grid.patience;
  return all[key] = measure_script(script, grid.rows, grid.sectors, patience);
}

void run_script(benchmark::State& state, const TickScript& script, const Grid& grid,
                Effort effort) {
  for (auto _ : state) {
    const ScriptTimes& t = measured(script, grid, effort);
    state.SetIterationTime(1e-9 * t.all.median);
    state.counters["median_ns"] = t.all.median;
    state.counters["p99_ns"] = t.all.p99;
    state.counters["p999_ns"] = t.all.p999;
    state.counters["least_p999_ns"] = t.least_p999;
    state.counters["least_cpu_p999_ns"] = t.least_cpu_p999;
    state.counters["worst_ns"] = t.all.worst;
    state.counters["visited"] = t.visited;
    state.counters["touched"] = t.touched;
    state.counters["ns_per_visited"] = t.visited > 0.0 ? t.all.median / t.visited : 0.0;
    char label[160];
    std::snprintf(label, sizeof label, "hash=%016llx %.*s", static_cast<unsigned long long>(t.hash),
                  static_cast<int>(script.says.size()), script.says.data());
    state.SetLabel(label);
  }
}

// The slowest script's tail, in the calmest of its blocks.
Figures tail_on_the_finest_grid(Effort effort) {
  Figures figures{
      {"p999_us_6400x2880", 0.0}, {"p999_us_6400x2880_cpu", 0.0}, {"p999_us_6400x2880_all", 0.0}};
  for (const TickScript& script : tick_scripts()) {
    const ScriptTimes& t = measured(script, kFinest, effort);
    figures[0].second = std::max(figures[0].second, 1e-3 * t.least_p999);
    figures[1].second = std::max(figures[1].second, 1e-3 * t.least_cpu_p999);
    figures[2].second = std::max(figures[2].second, 1e-3 * t.all.p999);
    figures.emplace_back("p999_us_6400x2880_" + std::string(script.name), 1e-3 * t.least_p999);
    figures.emplace_back("p999_us_6400x2880_cpu_" + std::string(script.name),
                         1e-3 * t.least_cpu_p999);
  }
  return figures;
}

void run_goal(benchmark::State& state, const std::function<Figures()>& goal) {
  for (auto _ : state) {
    Figures figures;
    state.SetIterationTime(1e-9 * timed([&] { figures = goal(); }));
    for (const auto& [name, value] : figures) state.counters[name] = value;
  }
}

void declare(Effort effort) {
  const auto once = [](benchmark::internal::Benchmark* b, benchmark::TimeUnit unit) {
    b->Iterations(1)->UseManualTime()->Unit(unit);
  };
  const auto goal = [&](const char* name, const std::function<Figures()>& figures) {
    once(benchmark::RegisterBenchmark(
             name, [figures](benchmark::State& state) { run_goal(state, figures); }),
         benchmark::kSecond);
  };
  goal("goal/bytes", [] { return bytes_in_the_papers_scene(); });
  for (const Grid& grid : kGrids)
    for (const TickScript& script : tick_scripts()) {
      const std::string name = "script/" + std::string(script.name) + "/" +
                               std::to_string(grid.rows) + "x" + std::to_string(grid.sectors);
      once(benchmark::RegisterBenchmark(name.c_str(),
                                        [&script, &grid, effort](benchmark::State& state) {
                                          run_script(state, script, grid, effort);
                                        }),
           benchmark::kMicrosecond);
    }
  goal("goal/p999", [=] { return tail_on_the_finest_grid(effort); });
#ifdef ONGGI_WITH_SCENES
  goal("goal/presets", [=] { return preset_tails(effort); });
  goal("goal/finest_studio", [=] { return finest_studio(effort); });
  goal("goal/asleep", [=] { return asleep(effort); });
#else
  std::fprintf(stderr, "goal/presets, finest_studio, asleep: skipped, built without the kiosk.\n");
#endif
  goal("goal/paper_400x360", [=] { return paper_ratio(400, 360, effort); });
  goal("goal/paper_6400x2880", [=] { return paper_ratio(6400, 2880, effort); });
  goal("goal/floor", [=] { return floor_ratio(effort); });
  goal("goal/untouched_rows", [=] { return untouched_rows_ratio(effort); });
#ifdef ONGGI_WITH_OPENVDB
  goal("goal/openvdb", [=] { return openvdb_ratio(effort); });
#else
  std::fprintf(stderr, "goal/openvdb: skipped, built without OpenVDB (libopenvdb-dev).\n");
#endif
}

}  // namespace
}  // namespace onggi::bench

int main(int argc, char** argv) {
  onggi::bench::Effort effort;
  char** const end = argv + argc;
  char** const rest =
      std::remove_if(argv, end, [](const char* word) { return std::strcmp(word, "--short") == 0; });
  effort.few = rest != end;
  argc = static_cast<int>(rest - argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  onggi::bench::declare(effort);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
