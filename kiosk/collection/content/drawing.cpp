#include "kiosk/collection/content/drawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "kiosk/collection/content/drawn_outline.h"
#include "kiosk/ground/toml/toml_reader.h"

namespace onggi::content {

namespace {

using toml::OutlinePoint;
using Table = toml::TomlReader::Table;

/// Mm: no thinner wall was thrown, and no clay grid can hold one.
constexpr double kThinnest = 1.0;
constexpr double kLargest = 2000.0;  ///< mm
constexpr std::size_t kMostPoints = 500;

std::string in_mm(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
}

struct Drawn {
  std::vector<OutlinePoint> outer, inner;
  bool smooth = true;
  std::optional<double> ring_inner_radius, recess;
  double rounding = 0.0;
};

/// Checks each outline by itself. True if it can be joined to the other.
bool check_points(Table& root, const std::string& key, const std::vector<OutlinePoint>& points) {
  const std::size_t count = points.size();
  if (count < 2 || count > kMostPoints) {
    root.complain(key,
                  key + " has " + std::to_string(count) + " points, but a wall needs 2 to " +
                      std::to_string(kMostPoints) + ".",
                  "Give more points, or fewer: 20 to 40 draw a vessel well.");
    return false;
  }
  bool good = true;
  const auto complain = [&](std::size_t i, std::string what, std::string remedy) {
    root.complain_at(key, i, std::move(what), std::move(remedy));
    good = false;
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OutlinePoint& p = points[i];
    if (p.radius < 0.0)
      complain(i, "this radius is " + in_mm(p.radius) + ", but a radius cannot be negative.",
               "Measure the radius from the axis: 0 or more.");
    else if (p.height < 0.0)
      complain(i, "this height is " + in_mm(p.height) + ", below the surface the vessel stands on.",
               "Measure heights from the standing surface: 0 or more.");
    else if (p.radius > kLargest || p.height > kLargest)
      complain(i, "this point lies further out than " + in_mm(kLargest) + ".",
               "Write millimetres, for the vessel at its true size.");
    else if (i > 0 && p.radius == points[i - 1].radius && p.height == points[i - 1].height)
      complain(i, "this point is the same as the one before it.", "Leave one of the two out.");
  }
  return good;
}

bool check_ends(Table& root, const Drawn& d) {
  bool good = true;
  const auto complain = [&](const char* key, std::size_t i, std::string what, std::string remedy) {
    root.complain_at(key, i, std::move(what), std::move(remedy));
    good = false;
  };
  const OutlinePoint &foot = d.outer.front(), &rim = d.outer.back();
  const OutlinePoint &mouth = d.inner.front(), &floor = d.inner.back();
  if (foot.height != 0.0)
    complain("outer", 0,
             "outer begins at height " + in_mm(foot.height) + ", but the foot must be at height 0.",
             "Begin with the outer edge of the foot: [radius, 0].");
  if (foot.radius < kThinnest)
    complain("outer", 0,
             "the foot has a radius of " + in_mm(foot.radius) + ", too small to stand on.",
             "Begin with the outer edge of the foot: [radius, 0].");
  if (floor.radius != 0.0)
    complain("inner", d.inner.size() - 1,
             "inner ends at radius " + in_mm(floor.radius) + ", but it must end on the axis.",
             "End with the floor on the axis: [0, height].");
  if (floor.height < kThinnest)
    complain("inner", d.inner.size() - 1,
             "the floor is " + in_mm(floor.height) + " thick, but the minimum is " +
                 in_mm(kThinnest) + ".",
             "Raise the last point of inner.");
  for (std::size_t i = 1; i < d.outer.size(); ++i)
    if (d.outer[i].radius == 0.0)
      complain("outer", i, "the outer wall touches the axis.", "Keep its radius above 0.");
  for (std::size_t i = 0; i + 1 < d.inner.size(); ++i)
    if (d.inner[i].radius == 0.0)
      complain("inner", i, "the inner wall touches the axis before its end.",
               "Keep its radius above 0 up to the last point.");

  const double width = rim.radius - mouth.radius;
  if (width < kThinnest)
    complain("inner", 0,
             "at the rim the inner wall (" + in_mm(mouth.radius) + ") must be at least " +
                 in_mm(kThinnest) + " inside the outer wall (" + in_mm(rim.radius) + ").",
             "Begin inner at the rim's inner edge, nearer to the axis than the end of outer.");
  else if (std::abs(mouth.height - rim.height) > width + 2.0)
    complain("inner", 0,
             "the rim is open: outer ends at height " + in_mm(rim.height) +
                 " and inner begins at " + in_mm(mouth.height) + ".",
             "Let both outlines meet at the rim, one on each edge of it.");
  return good;
}

bool check_foot(Table& foot, const Drawn& d) {
  if (!d.ring_inner_radius && !d.recess) return true;
  if (!d.ring_inner_radius || !d.recess) {
    foot.complain("", "a foot ring needs both ring_inner_radius and recess.",
                  "Give both, or leave [foot] out for a flat foot.");
    return false;
  }
  const double ring = d.outer.front().radius - *d.ring_inner_radius;
  if (ring < kThinnest) {
    foot.complain(
        "ring_inner_radius",
        "the foot ring is " + in_mm(ring) + " wide, but the minimum is " + in_mm(kThinnest) + ".",
        "Make it smaller than the foot's outer radius, " + in_mm(d.outer.front().radius) + ".");
    return false;
  }
  return true;
}

std::vector<Vec2> underside(const Drawn& d) {
  if (!d.recess) return {{0.0, 0.0}};
  return {{0.0, *d.recess}, {*d.ring_inner_radius, *d.recess}, {*d.ring_inner_radius, 0.0}};
}

Outline outline_of(const Drawn& d, const std::vector<OutlinePoint>& points, bool level_end) {
  std::vector<Knot> knots;
  for (const OutlinePoint& p : points) knots.push_back({{p.radius, p.height}, p.corner});
  // A 150th of the vessel is finer than the eye can see in its outline on a screen.
  double size = 0.0;
  for (const OutlinePoint& p : d.outer) size = std::max({size, p.radius, p.height});
  return d.smooth ? smooth_outline(knots, size / 150.0, level_end) : straight_outline(knots);
}

/// Finds walls that cross or nearly touch, and names the nearest drawn point.
bool check_walls(Table& root, const std::vector<Vec2>& under, const Outline& outer,
                 const Outline& inner) {
  for (const auto& [key, chain] : {std::pair{"outer", &outer}, std::pair{"inner", &inner}})
    if (const auto at = self_crossing(chain->points)) {
      root.complain_at(key, chain->drawn[*at], std::string(key) + " crosses itself here.",
                       "Order the points along the wall, without going back.");
      return false;
    }
  std::vector<Vec2> outside = under;
  outside.insert(outside.end(), outer.points.begin(), outer.points.end());
  const double rim = length(outer.points.back() - inner.points.front());
  const auto narrow = too_near(outside, inner.points, kThinnest, rim);
  if (!narrow) return true;
  const std::size_t drawn = inner.drawn[narrow->point];
  if (narrow->distance == 0.0)
    root.complain_at("inner", drawn, "the inner wall crosses the outer wall here.",
                     "Move this point towards the inside, or the outer wall outwards.");
  else
    root.complain_at("inner", drawn,
                     "the wall is " + in_mm(narrow->distance) + " thick here, but the minimum is " +
                         in_mm(kThinnest) + ".",
                     "Move the two walls apart here.");
  return false;
}

Section section_of(const Drawn& d, const std::vector<Vec2>& under, const Outline& outer,
                   const Outline& inner) {
  std::vector<Vec2> wall = outer.points, cavity = inner.points;
  // Both edges of the rim are rounded; a rounding of half the width or more gives a half-round rim.
  const Vec2 edge = wall.back(), mouth = cavity.front();
  const double width = length(mouth - edge);
  const double rounding = std::min(d.rounding, 0.4999 * width);
  std::vector<Vec2> rim;
  if (rounding > 0.0) {
    const Vec2 across = (mouth - edge) * (rounding / width);
    rim = arc(shorten(wall, rounding), edge, edge + across);
    std::reverse(cavity.begin(), cavity.end());
    const std::vector<Vec2> inside = arc(mouth - across, mouth, shorten(cavity, rounding));
    std::reverse(cavity.begin(), cavity.end());
    rim.insert(rim.end(), inside.begin(), inside.end());
  }
  Section section;
  const auto append = [&](const std::vector<Vec2>& part) {
    for (const Vec2& p : part) section.outline.push_back(p * 0.001);
  };
  append(under);
  append(wall);
  append(rim);
  append(cavity);
  return section;
}

}  // namespace

DrawingRead check_drawing(const std::filesystem::path& toml) {
  DrawingRead read;
  toml::TomlReader reader(toml);
  Table root = reader.root();
  Table foot = root.child("foot");
  Table rim = root.child("rim");
  Drawn d;
  std::string units;
  root.require("title", "Name the vessel: title = \"Moon jar\".");
  root.require("source", "Say where the figures come from: source = \"Museum, number, book\".");
  root.require("units", "Write units = \"mm\".");
  root.require("outer", "Draw the outside: outer = [[40, 0], [55, 30]], from foot to rim in mm.");
  root.require("inner", "Draw the inside: inner = [[50, 30], [0, 6]], from rim to floor in mm.");
  root.text("title", read.drawing.title);
  root.text("source", read.drawing.source);
  if (root.text("units", units) && units != "mm")
    root.complain("units", "units is \"" + units + "\", but drawings are in millimetres.",
                  "Give all figures in millimetres and write units = \"mm\".");
  root.boolean("smooth", d.smooth);
  const bool outer_drawn = root.points("outer", d.outer),
             inner_drawn = root.points("inner", d.inner);
  double value = 0.0;
  if (foot.number("ring_inner_radius", value, 0.1, kLargest, "mm")) d.ring_inner_radius = value;
  if (foot.number("recess", value, 0.1, kLargest, "mm")) d.recess = value;
  rim.number("rounding", d.rounding, 0.0, 100.0, "mm");
  foot.finish();
  rim.finish();
  root.finish();

  if (reader.ok() && outer_drawn && inner_drawn) {
    const bool outer_good = check_points(root, "outer", d.outer);
    const bool inner_good = check_points(root, "inner", d.inner);
    if (outer_good && inner_good && check_ends(root, d) && check_foot(foot, d)) {
      const std::vector<Vec2> under = underside(d);
      const Outline outer = outline_of(d, d.outer, false);
      const Outline inner = outline_of(d, d.inner, true);
      if (check_walls(root, under, outer, inner))
        read.drawing.section = section_of(d, under, outer, inner);
    }
  }
  read.problems = reader.problems();
  read.keys_checked = reader.keys_checked();
  return read;
}

Result<Drawing> read_drawing(const std::filesystem::path& toml) {
  DrawingRead read = check_drawing(toml);
  if (!read.problems.empty()) return tl::unexpected<Problem>(read.problems.front());
  return read.drawing;
}

}  // namespace onggi::content
