#include <benchmark/benchmark.h>

#include <cmath>

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

/// A jar of range(0) sectors; tilted by range(1) degrees, so that its axis has to be looked for.
void extraction(benchmark::State& state) {
  TriangleMesh mesh = revolve(section_of(jar()), static_cast<int>(state.range(0)));
  const double tilt = static_cast<double>(state.range(1)) * 3.14159265358979 / 180.0;
  for (auto& p : mesh.positions) {
    const double x = p[0], y = p[1];
    p[0] = static_cast<float>(x * std::cos(tilt) - y * std::sin(tilt) + 0.7);
    p[1] = static_cast<float>(x * std::sin(tilt) + y * std::cos(tilt));
  }
  for (auto _ : state) {
    auto found = extract_profile(mesh, {}, "jar");
    if (!found) state.SkipWithError(found.error().what.c_str());
    benchmark::DoNotOptimize(found);
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}
BENCHMARK(extraction)->Args({16, 0})->Args({96, 0})->Args({96, 30})->Unit(benchmark::kMillisecond);

void comparison(benchmark::State& state) {
  const Profile target = jar(), made = scaled(jar(), 1.1);
  for (auto _ : state) benchmark::DoNotOptimize(compare(target, made, true));
}
BENCHMARK(comparison)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace onggi
