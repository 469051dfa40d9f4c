#include "engine/surface/brush.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "engine/surface/cut.h"
#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<BrushDef, int>> BrushDef::counts() {
  static constexpr DefField<BrushDef, int> kCounts[] = {
      {"pigment", &BrushDef::pigment, 0, kPigments - 1, ""},
      {"tracks", &BrushDef::tracks, 1, 9, ""}};
  return kCounts;
}

std::span<const DefField<BrushDef>> BrushDef::fields() {
  static constexpr DefField<BrushDef> kFields[] = {
      {"width", &BrushDef::width, 5e-4, 0.04, "m"},
      {"thickness", &BrushDef::thickness, 2e-6, 0.002, "m"},
      {"fill", &BrushDef::fill, 0.0, 1.0, ""},
      {"reach", &BrushDef::reach, 0.01, 100.0, "m"},
      {"drags", &BrushDef::drags, 0.0, 0.5, ""},
      {"wet_time", &BrushDef::wet_time, 1.0, 3600.0, "s"},
  };
  return kFields;
}

namespace {

/// The load below which a brush gives less: it is even for the first 60 % of its way.
constexpr std::int64_t kEven = kWhole * 2 / 5;
/// Of a full brush's width that an empty one still has, of kWhole.
constexpr std::int64_t kNarrowest = 600;

/// Hair is never even. What a track gives, of kWhole, and the load at which it has nothing more.
struct Track {
  std::int64_t gives, dry;
};
constexpr std::array<Track, 9> kTracks{{{1024, 40},
                                        {930, 200},
                                        {1080, 90},
                                        {880, 260},
                                        {1000, 20},
                                        {1110, 150},
                                        {950, 230},
                                        {1060, 70},
                                        {900, 300}}};

/// How full a brush feels, of kWhole.
std::int64_t fullness(const Station& at) {
  return std::min<std::int64_t>(at.load * kWhole / kEven, kWhole);
}

/// Half of the brush's width at a station, um. Light pressure lets only the tip touch.
std::int64_t half_width(const BrushDef& def, const Station& at) {
  const std::int64_t full = kNarrowest + (kWhole - kNarrowest) * fullness(at) / kWhole;
  const std::int64_t pressed = (kWhole + at.pressure) / 2;
  return micrometres(def.width) * full / kWhole * pressed / kWhole / 2;
}

/// Of the coat that a track lays, nm.
std::int64_t coat(const BrushDef& def, const Track& track, const Station& at) {
  if (at.load <= track.dry) return 0;
  return nanometres(def.thickness) * track.gives / kWhole * fullness(at) / kWhole;
}

constexpr std::int64_t kAhead = 2000;  // um: as far as the hairs reach

/// Takes wet slip along.
class Drag {
 public:
  Drag(Surface& surface, const BrushDef& def) : surface_(surface), def_(def) {}

  void go(const Station& from, const Station& to, std::int64_t a, std::int64_t b) {
    const auto dry = static_cast<std::int64_t>(def_.wet_time * 1e3);
    const std::int64_t wet = std::max<std::int64_t>(dry - to.age, 0);
    const std::int64_t share = micrometres(def_.drags) * wet / dry * to.pressure / kWhole;
    if (share == 0) return;
    lift(piece(surface_, from, to, -a, a, -b, b), share);
    if (lifted_.empty()) return;
    find_ahead(to, b);
    for (std::size_t pigment = 0; pigment < volumes_.size(); ++pigment)
      if (volumes_[pigment] > 0) lay(static_cast<int>(pigment), volumes_[pigment]);
  }

 private:
  void lift(const Quad& under, std::int64_t share) {
    lifted_.clear();
    volumes_.fill(0);
    each_cell_in(surface_, under, [&](int j, int i) {
      const Stratum top = surface_.slip(j, i).at(0);
      if (top.code == 0) return;
      const Volume volume =
          Volume{thickness_of(top.code)} * surface_.row(j).area / 1'000'000 * share;
      if (volume == 0) return;
      lift_slip(surface_, j, i, volume);
      volumes_[static_cast<std::size_t>(top.pigment)] += volume;
      lifted_.push_back({j, i, top.pigment, volume});
    });
  }

  /// Cells before the brush where it stands now.
  void find_ahead(const Station& at, std::int64_t half) {
    ahead_.clear();
    // The station with its back to where it goes: `beside` it is ahead.
    Station turned = at;
    turned.across_along = at.across_round;
    turned.across_round = static_cast<std::int16_t>(-at.across_along);
    const Corner low = beside(surface_, at, -half), high = beside(surface_, at, half);
    const Corner on = beside(surface_, turned, kAhead);
    const std::int64_t up = on.along - at.along, round = on.round - at.round;
    each_cell_in(surface_,
                 {low, high, Corner{high.along + up, high.round + round},
                  Corner{low.along + up, low.round + round}},
                 [&](int j, int i) {
                   if (!surface_.resist(j, i)) ahead_.emplace_back(j, i);
                 });
  }

  /// Evenly on the cells ahead; what finds no room there goes back to where it was.
  void lay(int pigment, Volume volume) {
    std::size_t left = ahead_.size();
    for (const auto& [j, i] : ahead_)
      volume -= lay_slip(surface_, j, i, pigment, volume / static_cast<Volume>(left--));
    for (const Lifted& one : lifted_)
      if (one.pigment == pigment && volume > 0)
        volume -= lay_slip(surface_, one.row, one.sector, pigment, std::min(volume, one.volume));
    // A cell that is full again has left no more than rests took.
    const int row = lifted_.front().row;
    surface_.set_rest(row, pigment, surface_.rest(row, pigment) + volume);
  }

  struct Lifted {
    int row = 0, sector = 0, pigment = 0;
    Volume volume = 0;
  };
  Surface& surface_;
  const BrushDef& def_;
  std::array<Volume, kPigments> volumes_{};
  std::vector<Lifted> lifted_;
  std::vector<std::pair<int, int>> ahead_;
};

}  // namespace

Work brush(Surface& surface, const BrushDef& def, std::span<const Station> stations) {
  Work work;
  Drag drag(surface, def);
  const std::int64_t fill = micrometres(def.fill);
  for (std::size_t n = 1; n < stations.size(); ++n) {
    const Station &from = stations[n - 1], &to = stations[n];
    if (to.pressure == 0) continue;
    const std::int64_t a = half_width(def, from), b = half_width(def, to);
    drag.go(from, to, a, b);
    for (std::int64_t k = 0; k < def.tracks; ++k) {
      const std::int64_t nm = coat(def, kTracks[static_cast<std::size_t>(k)], to);
      // The same edges as the tracks beside it have, and the pieces before and behind.
      const auto edge = [&](std::int64_t half, std::int64_t track) {
        return floor_div(half * (2 * track - def.tracks), def.tracks);
      };
      each_cell_in(
          surface, piece(surface, from, to, edge(a, k), edge(a, k + 1), edge(b, k), edge(b, k + 1)),
          [&](int j, int i) {
            brush_off(surface, j, i);
            if (nm == 0 || surface.resist(j, i)) return;
            const std::int64_t hollow = std::max(-surface.top(j, i), 0);
            const std::int64_t high = nm + hollow * fill / 1'000'000;
            work.slip_laid += lay_slip(surface, j, i, def.pigment, high * surface.row(j).area);
            surface.set_burnish(j, i, 0);
          });
    }
  }
  return work;
}

}  // namespace onggi::surface
