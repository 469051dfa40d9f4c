#include "engine/surface/wipe.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<WipeDef>> WipeDef::fields() {
  static constexpr DefField<WipeDef> kFields[] = {
      {"width", &WipeDef::width, 0.002, 0.03, "m"},
      {"leaves", &WipeDef::leaves, 0.0, 2e-4, "m"},
      {"ridge", &WipeDef::ridge, 5e-5, 5e-4, "m"},
      {"wet_time", &WipeDef::wet_time, 1.0, 3600.0, "s"},
  };
  return kFields;
}

namespace {

constexpr std::int64_t kStrip = 1000;  // um: a ridge fills one strip beside the tool, then the next
constexpr int kMostStrips = 24;

/// The finger's way from one station to the next.
class Finger {
 public:
  Finger(Surface& surface, const WipeDef& def)
      : surface_(surface), def_(def), half_(micrometres(def.width) / 2) {}

  void go(const Station& from, const Station& to) {
    const Volume taken = take(from, to);
    Volume left = taken / 2;
    Volume right = taken - left;
    for (int strip = 0; strip < kMostStrips && left + right > 0; ++strip) {
      const std::int64_t near = half_ + strip * kStrip, far = near + kStrip;
      left = pile(piece(surface_, from, to, near, far, near, far), left);
      right = pile(piece(surface_, from, to, -far, -near, -far, -near), right);
    }
    give_back(left + right, row_of(surface_, to.along));
  }

 private:
  /// Lifts the wet glaze over the film.
  Volume take(const Station& from, const Station& to) {
    wiped_.clear();
    const auto dry = static_cast<std::int64_t>(def_.wet_time * 1e3);
    const std::int64_t wet = std::max<std::int64_t>(dry - to.age, 0);
    const int film = static_cast<int>(nanometres(def_.leaves) / kGlazeUnit);
    Volume taken = 0;
    each_cell_in(surface_, piece(surface_, from, to, -half_, half_, -half_, half_),
                 [&](int j, int i) {
                   const int glaze = surface_.glaze(j, i);
                   const std::int64_t over = std::max(glaze - film, 0);
                   const auto units = static_cast<int>(over * wet / dry * to.pressure / kWhole);
                   if (units == 0) return;
                   surface_.set_glaze(j, i, glaze - units);
                   wiped_.emplace_back(j, i);
                   taken += Volume{units} * kGlazeUnit * surface_.row(j).area;
                 });
    return taken;
  }

  /// Returns what is left of `volume` when each cell of `strip` has as much as a ridge may rise.
  Volume pile(const Quad& strip, Volume volume) {
    each_cell_in(surface_, strip, [&](int j, int i) {
      const Volume most = nanometres(def_.ridge) * surface_.row(j).area;
      volume -= lay_glaze(surface_, j, i, std::min(volume, most));
    });
    return volume;
  }

  /// Where the ridges are full, at an end of the outline for one, the glaze stays under the finger.
  /// Its cells have room for it but for what older rests took of that, which is the row's rest
  /// again.
  void give_back(Volume volume, int row) {
    for (const auto& [j, i] : wiped_) volume -= lay_glaze(surface_, j, i, volume);
    surface_.set_rest(row, Surface::kGlazeRest, surface_.rest(row, Surface::kGlazeRest) + volume);
  }

  Surface& surface_;
  const WipeDef& def_;
  std::int64_t half_;
  std::vector<std::pair<int, int>> wiped_;
};

}  // namespace

Work wipe(Surface& surface, const WipeDef& def, std::span<const Station> stations) {
  Finger finger(surface, def);
  for (std::size_t n = 1; n < stations.size(); ++n)
    if (stations[n].pressure > 0) finger.go(stations[n - 1], stations[n]);
  return {};
}

}  // namespace onggi::surface
