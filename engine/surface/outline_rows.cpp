#include "engine/surface/outline_rows.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"
#include "engine/math/vec.h"

namespace onggi::surface {

namespace {

/// A straight piece of the outline. x: radius, y: height; m.
struct Piece {
  Vec2 from, to;
  Part part;
};

std::vector<Piece> pieces_of(const Profile& profile) {
  std::vector<Piece> pieces;
  const std::vector<ProfilePoint>& points = profile.points;
  for (std::size_t i = 1; i < points.size(); ++i)
    pieces.push_back({{points[i - 1].outer, points[i - 1].height},
                      {points[i].outer, points[i].height},
                      Part::outside});
  const double top = profile.height();
  Vec2 at{points.back().inner, top};
  pieces.push_back({{points.back().outer, top}, at, Part::lip});
  for (std::size_t i = points.size() - 1; i > 0 && points[i - 1].inner > 0.0; --i) {
    const Vec2 next{points[i - 1].inner, points[i - 1].height};
    pieces.push_back({at, next, Part::inside});
    at = next;
  }
  if (at.x > 0.0) pieces.push_back({at, {0.0, at.y}, Part::floor});
  return pieces;
}

/// Across the surface, m: a sloping wall is thinner than it is wide.
double wall_at(const Profile& profile, const Piece& piece, double height) {
  const double across = profile.outer_at(height) - profile.inner_at(height);
  if (piece.part == Part::floor) return height;
  if (piece.part == Part::lip) return across;
  const Vec2 way = piece.to - piece.from;
  return across * std::abs(way.y) / length(way);
}

Row row_at(const Profile& profile, const Piece& piece, double way) {
  const Vec2 at = piece.from + (way / length(piece.to - piece.from)) * (piece.to - piece.from);
  Row row{at.y, at.x, piece.part, 0, 0, 0};
  row.wall = static_cast<int>(wall_at(profile, piece, at.y) * 1e6);
  row.width = static_cast<int>(2.0 * portable::kPi * at.x / kSectors * 1e9);
  row.area = static_cast<int>(std::int64_t{row.width} * kRowHeight / kNanometres);
  return row;
}

}  // namespace

Result<std::vector<Row>> outline_of(const Profile& profile, const std::string& name) {
  if (const Result<void> valid = validate(profile, name); !valid)
    return tl::unexpected<Problem>(valid.error());
  std::vector<Row> rows;
  double begin = 0.0;  // of the piece, m from the foot
  bool wide = true;
  for (const Piece& piece : pieces_of(profile)) {
    const double end = begin + length(piece.to - piece.from);
    // The middles of rows that lie on this piece. What comes after a narrow place is left out, too:
    // rows have no gaps.
    while (wide) {
      const double middle = (static_cast<double>(rows.size()) + 0.5) * kRowHeight * 1e-6;
      if (middle >= end) break;
      const Row row = row_at(profile, piece, middle - begin);
      wide = row.radius >= kLeastRadius;
      if (!wide) break;
      if (rows.size() == kMostRows)
        return problem(name, "its outline is longer than 2 m, too long to be decorated.",
                       "Scale the pot to the wheel first.");
      rows.push_back(row);
    }
    begin = end;
  }
  if (rows.empty())
    return problem(name, "its foot is within 6 mm of the axis, so there is nothing to decorate.",
                   "Give radii in metres.");
  return rows;
}

}  // namespace onggi::surface
