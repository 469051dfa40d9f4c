// What a tick costs: tests/bench/README.md. --short does a few ticks of everything; --goals lists
// what is wanted, a line each.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include "tests/bench/blows.h"
#include "tests/bench/goal_list.h"
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
    {400, 360, {20000, 0, 0.0}}, {1600, 720, {4000, 0, 0.0}}, {6400, 2880, {2000, 16000, 2.5}}};
constexpr const Grid& kFinest = kGrids[2];

Figures& all_figures() {
  static Figures all;
  return all;
}

// Each script is measured once, whoever asks.
const ScriptTimes& measured(const TickScript& script, const Grid& grid, Effort effort) {
  static std::map<std::pair<std::string_view, int>, ScriptTimes> all;
  const auto key = std::pair{script.name, grid.rows};
  const auto found = all.find(key);
  if (found != all.end()) return found->second;
  const Patience patience = effort.few ? Patience{12, 0, 0.0} : grid.patience;
  return all[key] = measure_script(script, grid.rows, grid.sectors, patience);
}

void run_script(benchmark::State& state, const TickScript& script, const Grid& grid,
                Effort effort) {
  for (auto _ : state) {
    const ScriptTimes& t = measured(script, grid, effort);
    state.SetIterationTime(1e-9 * t.wall.median);
    state.counters["median_ns"] = t.wall.median;
    state.counters["p99_ns"] = t.wall.p99;
    state.counters["p999_ns"] = t.wall.p999;
    state.counters["p999_of_tick"] = t.wall.p999 / kTickNs;
    state.counters["cpu_p999_ns"] = t.cpu.p999;
    state.counters["worst_ns"] = t.wall.worst;
    state.counters["visited"] = t.visited;
    state.counters["touched"] = t.touched;
    state.counters["ns_per_visited"] = t.visited > 0.0 ? t.wall.median / t.visited : 0.0;
    char label[160];
    std::snprintf(label, sizeof label, "hash=%016llx %.*s", static_cast<unsigned long long>(t.hash),
                  static_cast<int>(script.says.size()), script.says.data());
    state.SetLabel(label);
  }
}

// The slowest script's tail.
Figures tail_on_the_finest_grid(Effort effort) {
  Figures figures;
  double most = 0.0;
  double most_cpu = 0.0;
  for (const TickScript& script : tick_scripts()) {
    const ScriptTimes& t = measured(script, kFinest, effort);
    most = std::max(most, t.wall.p999);
    most_cpu = std::max(most_cpu, t.cpu.p999);
    add_tail(figures, "6400x2880_" + std::string(script.name), t.wall.p999);
  }
  add_tail(figures, "6400x2880", most);
  add_tail(figures, "6400x2880_cpu", most_cpu);
  return figures;
}

// What came of every goal, once all figures are there.
void print_goals() {
  const Figures& all = all_figures();
  for (const Goal& goal : goals()) {
    const auto found = std::ranges::find(all, goal.counter, &Figures::value_type::first);
    if (found == all.end()) continue;  // filtered out, or skipped by name
    const bool met = goal.at_least ? found->second >= goal.bound : found->second <= goal.bound;
    std::fprintf(stderr, "%-32s %10.4g   %s %-6g %s\n", found->first.c_str(), found->second,
                 goal.at_least ? "at least" : "at most ", goal.bound, met ? "met" : "MISSED");
  }
}

void run_goal(benchmark::State& state, const std::function<Figures()>& goal) {
  for (auto _ : state) {
    Figures figures;
    state.SetIterationTime(1e-9 * timed([&] { figures = goal(); }));
    for (const auto& [name, value] : figures) state.counters[name] = value;
    all_figures().insert(all_figures().end(), figures.begin(), figures.end());
  }
}

void run_blows(benchmark::State& state, const Grid& grid, Effort effort) {
  for (auto _ : state) {
    const Times t = time_blows(grid.rows, grid.sectors, effort.few ? 3 : 200);
    state.SetIterationTime(1e-9 * t.median);
    state.counters["median_ns"] = t.median;
    state.counters["p99_ns"] = t.p99;
    state.counters["worst_ns"] = t.worst;
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
  for (const Grid& grid : kGrids)
    once(benchmark::RegisterBenchmark(
             ("blow/" + std::to_string(grid.rows) + "x" + std::to_string(grid.sectors)).c_str(),
             [&grid, effort](benchmark::State& state) { run_blows(state, grid, effort); }),
         benchmark::kMicrosecond);
  goal("goal/p999", [=] { return tail_on_the_finest_grid(effort); });
#ifdef ONGGI_WITH_SCENES
  goal("goal/presets", [=] { return preset_tails(effort); });
  goal("goal/finest_studio", [=] { return finest_studio(effort); });
  goal("goal/asleep", [=] { return asleep(effort); });
  goal("goal/tools", [=] { return tools_pushed(effort); });
#else
  std::fprintf(stderr,
               "goal/presets, finest_studio, asleep, tools: skipped, built without the kiosk.\n");
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
  if (argc == 2 && std::strcmp(argv[1], "--goals") == 0) {
    for (const onggi::bench::Goal& goal : onggi::bench::goals())
      std::printf("%s %s %g\n", goal.counter, goal.at_least ? ">=" : "<=", goal.bound);
    return 0;
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  onggi::bench::declare(effort);
  benchmark::RunSpecifiedBenchmarks();
  if (!effort.few) onggi::bench::print_goals();
  return 0;
}
