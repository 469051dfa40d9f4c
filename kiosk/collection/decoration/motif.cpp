#include "kiosk/collection/decoration/motif.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

namespace onggi::decoration {

namespace {

constexpr int kLinks = 8;
constexpr double kFarthest = 1000.0;  // units of a figure

/// The way's direction at point n: along its neighbours, and nowhere at a corner or an end.
Vec2 tangent(const std::vector<toml::OutlinePoint>& points, std::size_t n, bool closed) {
  const std::size_t count = points.size();
  const bool end = !closed && (n == 0 || n + 1 == count);
  if (end || points[n].corner) return {};
  const toml::OutlinePoint &before = points[(n + count - 1) % count],
                           &next = points[(n + 1) % count];
  return 0.5 * Vec2{next.radius - before.radius, next.height - before.height};
}

/// True for an area without width, or a line without length. An area that crosses itself has width.
bool is_nothing(const std::vector<Vec2>& way, bool closed) {
  constexpr double kLeast = 1e-3;  // units of a figure: a fiftieth of a line's width
  const Vec2 first = way.front();
  Vec2 far{};  // from the first point to the one that is farthest from it
  for (const Vec2& p : way)
    if (length(p - first) > length(far)) far = p - first;
  const double reach = length(far);
  if (!closed || reach < kLeast) return reach < kLeast;
  double wide = 0.0;
  for (const Vec2& p : way) {
    const Vec2 from = p - first;
    wide = std::max(wide, std::abs(far.x * from.y - far.y * from.x) / reach);
  }
  return wide < kLeast;
}

std::vector<Motif::Drawn::Way> read_ways(toml::TomlReader::Table& motif, const char* name,
                                         bool closed) {
  std::vector<Motif::Drawn::Way> ways;
  for (toml::TomlReader::Table& table : motif.children(name)) {
    std::vector<toml::OutlinePoint> points;
    bool round = true;
    table.require("points", "Give its points: points = [[-0.5, 0], [0, 0.5], [0.5, 0]].");
    table.boolean("smooth", round);
    if (table.points("points", points, "x, y")) {
      const std::size_t least = closed ? 3 : 2;
      if (points.size() < least || points.size() > kMostPoints) {
        table.complain("points",
                       "it has " + std::to_string(points.size()) + " points, but needs " +
                           std::to_string(least) + " to " + std::to_string(kMostPoints) + ".",
                       "Give more points, or fewer.");
      } else {
        for (toml::OutlinePoint& p : points) p.corner = p.corner || !round;
        const bool far = std::any_of(points.begin(), points.end(), [](const toml::OutlinePoint& p) {
          return std::max(std::abs(p.radius), std::abs(p.height)) > kFarthest;
        });
        if (far)
          table.complain("points", "a point lies farther than 1000 units from the middle.",
                         "Draw the figure about 1 unit high, and set its size where it is used.");
        else if (is_nothing(smooth(points, closed), closed))
          table.complain("points",
                         closed ? "the area has no width: its points lie on one line."
                                : "the line has no length: its points lie on one place.",
                         "Move a point, or leave it out.");
        ways.push_back(std::move(points));
      }
    }
    table.finish();
  }
  return ways;
}

}  // namespace

Motif read_motif(toml::TomlReader::Table& table, const std::string& id) {
  Motif::Drawn drawn{read_ways(table, "fill", true), read_ways(table, "line", false)};
  if (!table.has("fill") && !table.has("line"))
    table.complain(
        "", "the motif \"" + id + "\" has nothing to draw.",
        "Give it an area, [[motif." + id + ".fill]], or a line, [[motif." + id + ".line]].");
  return motif_of(id, std::move(drawn));
}

Motif motif_of(std::string id, Motif::Drawn drawn) {
  Motif motif;
  for (const auto& points : drawn.fills) motif.fills.push_back(smooth(points, true));
  for (const auto& points : drawn.lines) motif.lines.push_back(smooth(points, false));
  motif.id = std::move(id);
  motif.drawn = std::move(drawn);
  return motif;
}

void read_source(toml::TomlReader::Table& table, const char* key, const char* remedy,
                 std::string& out) {
  table.require(key, remedy);
  if (table.text(key, out) && out.find_first_not_of(" \t\r\n") == std::string::npos)
    table.complain(key, std::string(key) + " is empty.", remedy);
}

bool read_length(toml::TomlReader::Table& table, const std::string& key, double unit, double low,
                 double high, double& out) {
  double value = 0.0;
  if (!table.number(key, value, low, high, unit == 1e-6 ? "um" : "mm")) return false;
  out = unit * value;
  return true;
}

std::vector<Vec2> smooth(const std::vector<toml::OutlinePoint>& points, bool closed) {
  std::vector<Vec2> out;
  const std::size_t count = points.size(), pieces = closed ? count : count - 1;
  for (std::size_t n = 0; n < pieces; ++n) {
    const std::size_t next = (n + 1) % count;
    const Vec2 a{points[n].radius, points[n].height}, b{points[next].radius, points[next].height};
    const Vec2 from = tangent(points, n, closed), to = tangent(points, next, closed);
    for (int k = 0; k < kLinks; ++k) {
      const double t = static_cast<double>(k) / kLinks, u = 1.0 - t;
      out.push_back((1.0 + 2.0 * t) * u * u * a + t * u * u * from + t * t * (3.0 - 2.0 * t) * b -
                    t * t * u * to);
    }
  }
  if (!closed) out.push_back({points.back().radius, points.back().height});
  return out;
}

}  // namespace onggi::decoration
