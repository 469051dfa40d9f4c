#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <vector>

#include "engine/surface/laws.h"
#include "engine/surface/melt.h"

namespace onggi {
namespace {

using namespace surface;
constexpr double kWay = 0.1;      // m of a stroke
constexpr double kWidth = 0.006;  // m of the brush

/// Of this thread's own work: other programs' does not count.
double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> of) {
  std::nth_element(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2), of.end());
  return of[of.size() / 2];
}

Surface jar() {
  return *Surface::create({{{0.0, 0.050, 0.0},
                            {0.008, 0.052, 0.046},
                            {0.110, 0.080, 0.074},
                            {0.180, 0.040, 0.035},
                            {0.200, 0.045, 0.041}}},
                          "jar");
}

/// A pot as other programs paint it: one colour a texel, and a soft round mask that is blended at
/// each quarter of its radius, in whole numbers, row by row. Texels are the surface's cells.
class Painted {
 public:
  Painted(int rows, double texel) : rows_(rows), radius_(0.5 * kWidth / texel) {
    side_ = 2 * static_cast<int>(std::ceil(radius_)) + 1;
    for (int y = 0; y < side_; ++y)
      for (int x = 0; x < side_; ++x) {
        const double far = std::hypot(x - side_ / 2, y - side_ / 2) / radius_;
        mask_.push_back(static_cast<std::uint8_t>(255.0 * std::clamp((1.0 - far) * 4.0, 0.0, 1.0)));
      }
    texels_.assign(static_cast<std::size_t>(rows) * kSectors * 4, 120);
  }
  void stroke(double from_row, double to_row, double sector) {
    for (double at = from_row; at < to_row; at += 0.25 * radius_)
      dab(static_cast<int>(at), static_cast<int>(sector));
  }
  std::size_t bytes() const { return texels_.size(); }

 private:
  void dab(int row, int sector) {
    for (int y = 0; y < side_; ++y) {
      const int j = row + y - side_ / 2;
      if (j < 0 || j >= rows_) continue;
      const std::uint8_t* mask = mask_.data() + y * side_;
      for (int x = 0; x < side_; ++x) {
        const int i = wrapped(sector + x - side_ / 2);
        std::uint8_t* texel =
            texels_.data() +
            (static_cast<std::size_t>(j) * kSectors + static_cast<std::size_t>(i)) * 4;
        const int alpha = mask[x];
        for (int k = 0; k < 4; ++k)
          texel[k] = static_cast<std::uint8_t>(texel[k] + (kColor[k] - texel[k]) * alpha / 255);
      }
    }
  }

  static constexpr int kColor[4] = {240, 235, 220, 255};
  int rows_, side_ = 0;
  double radius_;
  std::vector<std::uint8_t> mask_, texels_;
};

std::vector<Station> stations(const Surface& surface, double turns) {
  Tracer tracer(surface, 100.0);
  tracer.go({0.03, turns}), tracer.go({0.03 + kWay, turns}), tracer.lift();
  return tracer.stations();
}

/// A stroke of 100 mm with the tool of range(0): 0 a brush on bare clay, 1 a brush over wet slip, 2
/// a needle, 3 a finger in glaze. Its time a millimetre, and as a share of the painted texture's.
void stroke(benchmark::State& state) {
  const Surface bare = jar();
  Surface surface = bare;
  DipDef dip;
  dip.to = 2.0;
  if (state.range(0) == 1) dip.coat = 1;
  if (state.range(0) == 1 || state.range(0) == 3)
    if (!apply(surface, {dip, {}, false})) state.SkipWithError("the dip failed");
  Tool tool = CutDef{};
  BrushDef brush;
  brush.width = kWidth;
  if (state.range(0) < 2) tool = brush;
  WipeDef finger;
  finger.width = kWidth;
  if (state.range(0) == 3) tool = finger;
  Painted painted(surface.rows(), 2.5e-4);
  std::vector<double> ours, theirs;
  int n = 0;
  for (auto _ : state) {
    const double turns = 0.05 * (n++ % 20);
    double begin = cpu_seconds();
    painted.stroke(120, 120 + kWay / 2.5e-4, turns * kSectors);
    theirs.push_back(cpu_seconds() - begin);
    const Stroke one{tool, stations(surface, turns), false};
    begin = cpu_seconds();
    if (!apply(surface, one)) state.SkipWithError("the stroke failed");
    ours.push_back(cpu_seconds() - begin);
    state.SetIterationTime(ours.back());
  }
  state.counters["us_a_mm"] = 1e6 * median(ours) / (1e3 * kWay);
  state.counters["per_painted"] = median(ours) / median(theirs);
  state.counters["MB"] = 1e-6 * static_cast<double>(surface.bytes());
  state.counters["painted_MB"] = 1e-6 * static_cast<double>(painted.bytes());
}
BENCHMARK(stroke)->DenseRange(0, 3)->UseManualTime()->Iterations(40);

/// The melt of that jar's glaze.
void melt(benchmark::State& state) {
  Surface surface = jar();
  DipDef dip;
  dip.to = 2.0;
  if (!apply(surface, {dip, {}, false})) state.SkipWithError("the dip failed");
  for (auto _ : state) {
    auto melting = Melt::begin(surface, {});
    while (!melting->go_on(1 << 20)) {
    }
    benchmark::DoNotOptimize(melting);
  }
}
BENCHMARK(melt)->Unit(benchmark::kMillisecond)->Iterations(4);

}  // namespace
}  // namespace onggi
