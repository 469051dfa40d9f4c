#include "engine/surface/smoke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/math/portable.h"
#include "engine/math/random.h"
#include "engine/surface/micrometres.h"
#include "engine/surface/station.h"

namespace onggi::surface {

std::span<const DefField<SmokeDef, int>> SmokeDef::counts() {
  static constexpr DefField<SmokeDef, int> kCounts[] = {
      {"seed", &SmokeDef::seed, 0, 1'000'000, ""}, {"turn", &SmokeDef::turn, 0, kSectors - 1, ""}};
  return kCounts;
}

std::span<const DefField<SmokeDef>> SmokeDef::fields() {
  static constexpr DefField<SmokeDef> kFields[] = {
      {"from", &SmokeDef::from, 0.0, 2.1, "m"},
      {"soft", &SmokeDef::soft, 0.001, 0.05, "m"},
      {"wander", &SmokeDef::wander, 0.0, 0.05, "m"},
      {"carbon", &SmokeDef::carbon, 0.0, 1.0, ""},
  };
  return kFields;
}

namespace {

/// How far the edge stands over `from` at each sector, um: a few waves round the pot, the longer
/// the higher, together no more than half of `wander`.
std::vector<std::int64_t> edge_of(const SmokeDef& def) {
  constexpr int kWaves = 6;
  Random random(static_cast<std::uint64_t>(def.seed));
  std::array<double, kWaves> height{}, phase{};
  double sum = 0.0;
  for (std::size_t k = 0; k < kWaves; ++k) {
    height[k] = random.uniform(0.5, 1.0) / static_cast<double>(k + 1);
    phase[k] = random.uniform();
    sum += height[k];
  }
  std::vector<std::int64_t> edge(kSectors);
  for (int i = 0; i < kSectors; ++i) {
    double high = 0.0;
    for (std::size_t k = 0; k < kWaves; ++k) {
      // Whole sectors, so that a turn changes no rounding.
      const int wave = i * static_cast<int>(k + 1) % kSectors;
      high += height[k] * portable::sin(2.0 * portable::kPi * (wave * (1.0 / kSectors) + phase[k]));
    }
    edge[static_cast<std::size_t>(wrapped(i + def.turn))] =
        micrometres(0.5 * def.wander * high / sum);
  }
  return edge;
}

}  // namespace

Work smoke(Surface& surface, const SmokeDef& def) {
  const std::vector<std::int64_t> edge = edge_of(def);
  const std::int64_t soft = micrometres(def.soft), from = micrometres(def.from);
  const auto black = static_cast<std::int64_t>(def.carbon * kMostSmoke);
  for (int j = 0; j < surface.rows(); ++j) {
    const std::int64_t middle = std::int64_t{j} * kRowHeight + kRowHeight / 2;
    for (int i = 0; i < kSectors; ++i) {
      const std::int64_t over = middle - from - edge[static_cast<std::size_t>(i)] + soft / 2;
      const std::int64_t share = std::clamp<std::int64_t>(over * kWhole / soft, 0, kWhole);
      // Smooth at both ends: 3 s^2 - 2 s^3.
      const std::int64_t eased = share * share * (3 * kWhole - 2 * share) / kWhole / kWhole;
      const auto carbon = static_cast<int>(black * eased / kWhole);
      surface.set_smoke(j, i, std::max(surface.smoke(j, i), carbon));
    }
  }
  return {};
}

}  // namespace onggi::surface
