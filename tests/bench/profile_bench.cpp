#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>
#include <random>

#include "engine/profile/extraction.h"
#include "engine/profile/measures.h"

namespace onggi {
namespace {

Profile jar() {
  Profile p;
  for (int i = 0; i < 261; ++i) {
    const double t = i / 260.0, outer = 0.06 + 0.09 * std::sin(3.0 * t) * (1.2 - t);
    p.points.push_back({0.30 * t, outer, t < 0.04 ? 0.0 : outer - 0.006});
  }
  return p;
}

using Clock = std::chrono::steady_clock;

double seconds_of(Clock::duration d) { return std::chrono::duration<double>(d).count(); }

/// A jar of range(0) sectors; tilted by range(1) degrees, so that its axis has to be looked for.
/// range(2): its triangles and vertices stand in no order, as a scanner's do.
/// `per_sort` is the time as a share of sorting as many numbers as there are triangles: a yardstick
/// of n log n that the same machine sets at the same moment. It must not rise with n.
void extraction(benchmark::State& state) {
  TriangleMesh mesh = revolve(section_of(jar()), static_cast<int>(state.range(0)));
  const double tilt = static_cast<double>(state.range(1)) * 3.14159265358979 / 180.0;
  for (auto& p : mesh.positions) {
    const double x = p[0], y = p[1];
    p[0] = static_cast<float>(x * std::cos(tilt) - y * std::sin(tilt) + 0.7);
    p[1] = static_cast<float>(x * std::sin(tilt) + y * std::cos(tilt));
  }
  std::mt19937 random(1);
  if (state.range(2) != 0) {
    std::vector<std::uint32_t> place(mesh.positions.size());
    std::iota(place.begin(), place.end(), 0u);
    std::shuffle(place.begin(), place.end(), random);
    auto moved = mesh.positions;
    for (std::size_t i = 0; i < place.size(); ++i) moved[place[i]] = mesh.positions[i];
    mesh.positions = std::move(moved);
    for (auto& t : mesh.triangles)
      for (auto& corner : t) corner = place[corner];
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
  }
  std::vector<float> numbers(mesh.triangles.size());
  std::uniform_real_distribution<float> any;
  double reading = 0.0, sorting = 0.0;
  for (auto _ : state) {
    for (float& x : numbers) x = any(random);
    auto begin = Clock::now();
    std::sort(numbers.begin(), numbers.end());
    sorting += seconds_of(Clock::now() - begin);
    begin = Clock::now();
    auto found = extract_profile(mesh, {}, "jar");
    const double seconds = seconds_of(Clock::now() - begin);
    if (!found) state.SkipWithError(found.error().what.c_str());
    benchmark::DoNotOptimize(found);
    reading += seconds;
    state.SetIterationTime(seconds);
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["per_sort"] = reading / sorting;
}
BENCHMARK(extraction)
    ->Args({16, 0, 0})
    ->Args({96, 0, 0})
    ->Args({96, 30, 0})
    ->Args({979, 0, 0})
    ->Args({979, 30, 0})
    ->Args({979, 30, 1})
    ->Args({1958, 30, 0})
    ->Args({3916, 30, 0})
    ->Args({7832, 30, 0})
    ->Args({7832, 30, 1})
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

void comparison(benchmark::State& state) {
  const Profile target = jar(), made = scaled(jar(), 1.1);
  for (auto _ : state) benchmark::DoNotOptimize(compare(target, made, true));
}
BENCHMARK(comparison)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace onggi
