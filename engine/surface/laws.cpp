#include "engine/surface/laws.h"

#include <cstdlib>
#include <string>
#include <type_traits>

#include "engine/base/field_check.h"
#include "engine/surface/ribbon.h"

namespace onggi::surface {

namespace {

template <class Def>
constexpr bool kWholePot = std::is_same_v<Def, DipDef> || std::is_same_v<Def, SmokeDef>;

void check_station(FieldCheck& check, const Surface& surface, const Station& at) {
  check.range("along", at.along, 0, surface.rows() * kRowHeight, "um");
  check.range("round", at.round, -double{kMostTurns} * kTurn, double{kMostTurns} * kTurn, "parts");
  check.range("pressure", at.pressure, 0, kWhole, "");
  check.range("load", at.load, 0, kWhole, "");
  const double along = at.across_along, round = at.across_round;
  const double square = (along * along + round * round) / (double{kUnit} * kUnit);
  check.require(square > 0.99 && square < 1.01, "across",
                "has not the length " + std::to_string(kUnit) + ".",
                "Write the two parts of a direction of that length.");
}

void check_step(FieldCheck& check, const Surface& surface, const Station& from, const Station& to) {
  const std::int64_t parts = std::abs(std::int64_t{to.round} - from.round);
  const std::int64_t um =
      parts * surface.row(row_of(surface, to.along)).width / (kParts * kNanometres);
  const std::int64_t up = std::abs(std::int64_t{to.along} - from.along);
  check.require(std::max(um, up) <= kLongestStep, "along",
                "is more than " + std::to_string(kLongestStep) + " um from the station before it.",
                "Put stations between: a Tracer does.");
}

void check_corner(FieldCheck& check, const Station& first, const Station& at) {
  check.require(std::abs(std::int64_t{at.round} - first.round) <= kTurn, "round",
                "is more than a turn from the first corner.", "Cut the figure in two.");
}

Result<void> check_stations(const Surface& surface, std::span<const Station> stations,
                            bool corners) {
  for (std::size_t n = 0; n < stations.size(); ++n) {
    FieldCheck check("stroke, station " + std::to_string(n + 1));
    check_station(check, surface, stations[n]);
    if (corners)
      check_corner(check, stations[0], stations[n]);
    else if (n > 0)
      check_step(check, surface, stations[n - 1], stations[n]);
    if (Result<void> valid = check.result(); !valid) return valid;
  }
  return {};
}

template <class Def>
Result<void> check_tool(const Def& def, std::size_t stations) {
  FieldCheck check(Def::kName);
  check_fields(check, def);
  if constexpr (kWholePot<Def>) {
    check.require(stations == 0, "stations", "are given, but it is not a stroke along a way.",
                  "Leave them out.");
  } else {
    check.require(stations > 0, "stations", "are missing.", "Give one at least.");
    check.require(stations <= kMostStations, "stations", "are more than a million.",
                  "Cut the stroke in two.");
  }
  if constexpr (std::is_same_v<Def, StampDef>) {
    const auto cells = static_cast<std::size_t>(def.side) * static_cast<std::size_t>(def.side);
    check.require(def.picture.size() == cells, "picture",
                  "has " + std::to_string(def.picture.size()) + " cells, not side x side.",
                  "Give " + std::to_string(cells) + " of them.");
  }
  if constexpr (std::is_same_v<Def, DipDef>)
    check.require(def.from < def.to, "to", "is not above from, so nothing is under.",
                  "Make it larger than from.");
  return check.result();
}

struct Apply {
  Surface& surface;
  std::span<const Station> stations;

  Work operator()(const CutDef& def) const { return cut(surface, def, stations); }
  Work operator()(const BrushDef& def) const { return brush(surface, def, stations); }
  Work operator()(const ScrapeDef& def) const { return scrape(surface, def, stations); }
  Work operator()(const WipeDef& def) const { return wipe(surface, def, stations); }
  Work operator()(const StampDef& def) const { return stamp(surface, def, stations); }
  Work operator()(const DipDef& def) const { return dip(surface, def); }
  Work operator()(const ResistDef& def) const { return resist(surface, def, stations); }
  Work operator()(const BurnishDef& def) const { return burnish(surface, def, stations); }
  Work operator()(const FillDef& def) const { return fill(surface, def, stations); }
  Work operator()(const CoilDef& def) const { return coil(surface, def, stations); }
  Work operator()(const SmokeDef& def) const { return smoke(surface, def); }
};

}  // namespace

Result<void> validate(const Surface& surface, const Stroke& stroke) {
  Result<void> valid = std::visit(
      [&](const auto& def) { return check_tool(def, stroke.stations.size()); }, stroke.tool);
  if (!valid) return valid;
  return check_stations(surface, stroke.stations, std::holds_alternative<FillDef>(stroke.tool));
}

Result<Work> apply(Surface& surface, const Stroke& stroke) {
  if (const Result<void> valid = validate(surface, stroke); !valid)
    return tl::unexpected<Problem>(valid.error());
  surface.begin_step(stroke.continues);
  const Work work = std::visit(Apply{surface, stroke.stations}, stroke.tool);
  if (!stroke.continues) surface.end_step();
  return work;
}

Stroke turned(Stroke stroke, int sectors) {
  for (Station& at : stroke.stations) at.round += sectors * kParts;
  if (SmokeDef* def = std::get_if<SmokeDef>(&stroke.tool)) def->turn = wrapped(def->turn + sectors);
  if (CoilDef* def = std::get_if<CoilDef>(&stroke.tool)) def->turn = wrapped(def->turn + sectors);
  return stroke;
}

Result<std::vector<Stroke>> repeated(const Stroke& stroke, int n) {
  if (n < 1 || kSectors % n != 0)
    return problem("repeat",
                   "repeat is " + std::to_string(n) + ", which does not divide the pot evenly.",
                   "Choose 2 to 8, 10, 12, 14, 15 or 16.");
  std::vector<Stroke> all;
  for (int k = 0; k < n; ++k) {
    all.push_back(turned(stroke, k * (kSectors / n)));
    all.back().continues = stroke.continues || k > 0;
  }
  return all;
}

}  // namespace onggi::surface
