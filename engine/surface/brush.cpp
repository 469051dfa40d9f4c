#include "engine/surface/brush.h"

#include <algorithm>
#include <array>

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

}  // namespace

Work brush(Surface& surface, const BrushDef& def, std::span<const Station> stations) {
  Work work;
  const std::int64_t fill = micrometres(def.fill);
  for (std::size_t n = 1; n < stations.size(); ++n) {
    const Station &from = stations[n - 1], &to = stations[n];
    if (to.pressure == 0) continue;
    const std::int64_t a = half_width(def, from), b = half_width(def, to);
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
