#include "kiosk/collection/decoration/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/math/portable.h"

namespace onggi::decoration {

namespace {

using namespace surface;

/// Corners need not be near to each other, so they are where they are.
std::vector<Station> corners_of(const Surface& surface, const std::vector<Vec2>& points,
                                const FigurePlace& at) {
  const double end = surface.rows() * kRowHeight;
  std::vector<Station> out;
  for (const Vec2& p : points) {
    Station corner;
    corner.along = static_cast<std::int32_t>(
        std::clamp(std::floor((at.along + p.y * at.up) * 1e6 + 0.5), 0.0, end));
    corner.round = static_cast<std::int32_t>(std::floor((at.turns + p.x * at.round) * kTurn + 0.5));
    out.push_back(corner);
  }
  return out;
}

/// From where to where an area reaches at height `y`; one that crosses itself has gaps.
std::vector<std::pair<double, double>> crossed(const std::vector<Vec2>& corners, double y) {
  std::vector<double> at;
  for (std::size_t n = 0; n < corners.size(); ++n) {
    const Vec2 &a = corners[n], &b = corners[(n + 1) % corners.size()];
    if ((a.y <= y) != (b.y <= y)) at.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::ranges::sort(at);
  std::vector<std::pair<double, double>> out;
  for (std::size_t n = 0; n + 1 < at.size(); n += 2) out.emplace_back(at[n], at[n + 1]);
  return out;
}

/// Ways across an area, `apart` of its units from each other, from edge to edge.
std::vector<std::vector<Vec2>> hatched(const std::vector<Vec2>& corners, double apart) {
  double low = corners.front().y, high = low;
  for (const Vec2& p : corners) low = std::min(low, p.y), high = std::max(high, p.y);
  std::vector<std::vector<Vec2>> ways;
  for (double y = low + 0.5 * apart; y < high; y += apart)
    for (const auto& [from, to] : crossed(corners, y)) ways.push_back({{from, y}, {to, y}});
  return ways;
}

}  // namespace

FigurePlace figure_place(const Surface& surface, double along, double turns, double size,
                         bool inside) {
  FigurePlace at{along, turns};
  // Angles grow to the left as seen from outside. Within, up goes back along the outline, and right
  // as seen is the other way round.
  at.up = inside ? -size : size;
  const auto row = static_cast<int>(along * 1e6) / kRowHeight;
  const double radius = surface.row(std::clamp(row, 0, surface.rows() - 1)).radius;
  at.round = -at.up / (2.0 * portable::kPi * radius);
  return at;
}

std::vector<Station> way_of(const Surface& surface, const std::vector<Vec2>& points,
                            const FigurePlace& at, bool closed, double reach) {
  Tracer tracer(surface, reach);
  const auto go = [&](const Vec2& p) {
    tracer.go({at.along + p.y * at.up, at.turns + p.x * at.round});
  };
  for (const Vec2& p : points) go(p);
  if (closed) go(points.front());
  tracer.lift();
  return tracer.stations();
}

std::vector<std::uint8_t> stamp_picture(const Motif& motif, int side) {
  std::vector<std::uint8_t> picture(static_cast<std::size_t>(side * side), 0);
  const double cell = 1.0 / side;
  for (const auto& corners : motif.fills)
    for (int row = 0; row < side; ++row)
      for (const auto& [from, to] : crossed(corners, (row + 0.5) * cell - 0.5))
        for (int column = 0; column < side; ++column) {
          const double x = (column + 0.5) * cell - 0.5;
          if (x >= from && x < to) picture[static_cast<std::size_t>(row * side + column)] = 255;
        }
  return picture;
}

Stroke stamp_stroke(StampDef stamp, const Motif& motif, double size, double along, double turns,
                    bool inside) {
  stamp.picture = stamp_picture(motif, stamp.side);
  stamp.size = size;
  Station station;
  station.along = static_cast<std::int32_t>(1e6 * along);
  station.round = static_cast<std::int32_t>(turns * kTurn);
  station.across_along = 0;
  station.across_round = static_cast<std::int16_t>(inside ? -kUnit : kUnit);
  return {std::move(stamp), {station}, false};
}

std::vector<Stroke> figure_strokes(const Surface& surface, const Motif& motif,
                                   const FigurePlace& at, const Tool& line,
                                   const std::optional<FillDef>& fill) {
  std::vector<Stroke> out;
  const auto draw = [&](const Tool& with, std::vector<Station> stations) {
    out.push_back({with, std::move(stations), !out.empty()});
  };
  const auto* carved = std::get_if<CutDef>(&line);
  const auto* brush = std::get_if<BrushDef>(&line);
  const double reach = brush != nullptr ? brush->reach : kEndlessWay;
  for (const auto& points : motif.fills) {
    if (fill) {
      draw(*fill, corners_of(surface, points, at));
      continue;
    }
    draw(line, way_of(surface, points, at, true));
    if (carved == nullptr || carved->section != CutDef::flat) continue;
    for (const auto& way : hatched(points, 0.8 * carved->width / std::abs(at.up)))
      draw(line, way_of(surface, way, at, false));
  }
  for (const auto& points : motif.lines) draw(line, way_of(surface, points, at, false, reach));
  return out;
}

}  // namespace onggi::decoration
