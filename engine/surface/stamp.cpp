#include "engine/surface/stamp.h"

#include <algorithm>

#include "engine/surface/micrometres.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

std::span<const DefField<StampDef, int>> StampDef::counts() {
  static constexpr DefField<StampDef, int> kCounts[] = {{"side", &StampDef::side, 2, 64, ""}};
  return kCounts;
}

std::span<const DefField<StampDef>> StampDef::fields() {
  static constexpr DefField<StampDef> kFields[] = {
      {"size", &StampDef::size, 0.001, 0.03, "m"},
      {"depth", &StampDef::depth, 0.0, 0.001, "m"},
  };
  return kFields;
}

namespace {

/// The nearest way round from `from` to `to`, -kTurn / 2 .. kTurn / 2 parts.
std::int64_t nearest_turn(std::int64_t from, std::int64_t to) {
  const std::int64_t way = to - from + kTurn / 2;
  return way - floor_div(way, kTurn) * kTurn - kTurn / 2;
}

void press(Surface& surface, const StampDef& def, const Station& at) {
  const std::int64_t size = micrometres(def.size), half = size / 2;
  // The station with its back to where it goes: `beside` it is ahead.
  Station turned = at;
  turned.across_along = at.across_round;
  turned.across_round = static_cast<std::int16_t>(-at.across_along);
  const auto corner = [&](std::int64_t left, std::int64_t ahead) {
    const Corner a = beside(surface, at, left), b = beside(surface, turned, ahead);
    return Corner{a.along + b.along - at.along, a.round + b.round - at.round};
  };
  const Quad square{corner(half, -half), corner(-half, -half), corner(-half, half),
                    corner(half, half)};
  const std::int64_t depth = micrometres(def.depth) * at.pressure / kWhole;
  each_cell_in(surface, square, [&](int j, int i) {
    const std::int64_t y = std::int64_t{j} * kRowHeight + kRowHeight / 2 - at.along;
    const std::int64_t x = floor_div(
        nearest_turn(at.round, std::int64_t{i} * kParts + kParts / 2) * surface.row(j).width,
        kParts * kNanometres);
    const auto cell = [&](std::int64_t way) {
      return std::clamp<std::int64_t>(floor_div((way / kUnit + half) * def.side, size), 0,
                                      def.side - 1);
    };
    const std::int64_t right = cell(-(y * at.across_along + x * at.across_round));
    const std::int64_t up = cell(y * turned.across_along + x * turned.across_round);
    const std::int64_t pixel = def.picture[static_cast<std::size_t>(up * def.side + right)];
    const auto down =
        static_cast<int>(std::min<std::int64_t>(depth * pixel / 255, surface.deepest(j)));
    if (pixel > 0 && surface.relief(j, i) > -down) surface.set_relief(j, i, -down);
  });
}

}  // namespace

Work stamp(Surface& surface, const StampDef& def, std::span<const Station> stations) {
  for (const Station& at : stations)
    if (at.pressure > 0) press(surface, def, at);
  return {};
}

}  // namespace onggi::surface
