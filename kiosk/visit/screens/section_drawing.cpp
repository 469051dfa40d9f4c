#include "kiosk/visit/screens/section_drawing.h"

#include <algorithm>
#include <cmath>

#include "kiosk/visit/screens/strokes.h"

namespace onggi::screens {

namespace {

constexpr int kDrawnHeights = 96;
constexpr float kTone = 0.22f;  // of the ink, for the vessel's cut wall

float unit_of(const Page& page) { return page.type().body / 25.0f; }

/// Position of a drawing: converts metres from the axis and above the foot to pixels.
struct Paper {
  float axis = 0, foot = 0;
  double scale = 1;
  std::pair<float, float> at(double x, double h) const {
    return {axis + static_cast<float>(x * scale), foot - static_cast<float>(h * scale)};
  }
};

/// Foot to rim on the right, over the rim, and down to the foot on the left.
Points outline(const Paper& paper, const Profile& p) {
  Points line;
  for (int i = 0; i <= kDrawnHeights; ++i) {
    const double h = p.height() * i / kDrawnHeights;
    line.push_back(paper.at(p.outer_at(h), h));
  }
  const double top = p.height(), rim = p.inner_at(top);
  line.push_back(paper.at(-rim, top));
  for (int i = kDrawnHeights; i >= 0; --i) {
    const double h = p.height() * i / kDrawnHeights;
    line.push_back(paper.at(-p.outer_at(h), h));
  }
  line.push_back(line.front());
  return line;
}

/// The inner wall of the left half, from the rim to the middle of the floor.
Points inside(const Paper& paper, const Profile& p) {
  Points line;
  const double floor = p.floor_height();
  for (int i = kDrawnHeights; i >= 0; --i) {
    const double h = floor + (p.height() - floor) * i / kDrawnHeights;
    line.push_back(paper.at(-p.inner_at(h), h));
  }
  line.push_back(paper.at(0, floor));
  return line;
}

/// The cut wall of the left half, in strips of two pixels.
void tone(Page& page, const Paper& paper, const Profile& p) {
  constexpr double kStrip = 2.0;
  const auto strips = static_cast<int>(std::floor(p.height() * paper.scale / kStrip));
  for (int i = 0; i < strips; ++i) {
    const double h = (i + 0.5) * kStrip / paper.scale;
    const double hollow = h < p.floor_height() ? 0.0 : p.inner_at(h);
    const auto [x, y] = paper.at(-p.outer_at(h), h);
    const float w = paper.at(-hollow, h).first - x;
    if (w > 0)
      page.draw(view::Box{{x, y - 1.0f, w, static_cast<float>(kStrip)},
                          0,
                          view::with_alpha(view::kInk, kTone),
                          0,
                          {}});
  }
}

/// From the pot's outline to the vessel's, on the right. A short way is drawn longer at its tail,
/// so that it is an arrow at all.
void arrow(Page& page, const Paper& paper, const view::Rect& room, const Profile& vessel,
           const Profile& pot, const score::Remark::Seen& seen) {
  const float unit = unit_of(page), least = 30 * unit, head = 13 * unit;
  const auto on = [&](const Profile& p, double share) {
    const double h = share * p.height();
    return paper.at(p.outer_at(h), h);
  };
  const auto [to_x, to_y] = on(vessel, seen.wanted);
  auto [x, y] = on(pot, seen.made);
  const float way = std::hypot(to_x - x, to_y - y);
  if (way < 0.5f) return;
  const float u = (to_x - x) / way, v = (to_y - y) / way;
  if (way < least) x = to_x - least * u, y = to_y - least * v;
  x = std::min(x, room.x + room.w);
  const view::Color ink = view::kDeepCeladon;
  const float aside = 0.7f * head, pen = 4.5f * unit;
  draw_stroke(page, {{x, y}, {to_x - pen * u, to_y - pen * v}}, ink, pen);
  page.draw(view::Line{{{to_x - head * u + aside * v, to_y - head * v - aside * u},
                        {to_x, to_y},
                        {to_x - head * u - aside * v, to_y - head * v + aside * u}},
                       {ink},
                       pen});
}

}  // namespace

void draw_vessels_line(Page& page, const Points& points) {
  page.draw(view::Line{points, {view::kInk}, 1.4f * unit_of(page)});
}

void draw_pots_line(Page& page, const Points& points) {
  draw_dashes(page, points, view::kIron, 2.4f * unit_of(page), 8.0f * unit_of(page));
}

void draw_section(Page& page, const view::Rect& room, const Profile& vessel, const Profile& pot,
                  double pixels_per_metre, std::span<const score::Remark> tries) {
  const double height = std::max(vessel.height(), pot.height());
  const double radius = std::max(vessel.points.empty() ? 0.0 : vessel.max_radius(),
                                 pot.points.empty() ? 0.0 : pot.max_radius());
  if (height <= 0 || radius <= 0) return;
  const float line = 2 * unit_of(page);
  const Paper paper{
      room.x + room.w / 2, room.y + room.h - line,
      std::min({static_cast<double>(room.h - 2 * line) / height,
                static_cast<double>(room.w - 2 * line) / (2 * radius), pixels_per_metre})};
  if (!vessel.points.empty()) tone(page, paper, vessel);
  page.draw(view::Line{{paper.at(0, 0), paper.at(0, height)}, {view::kFaintInk}, unit_of(page)});
  for (const Profile* p : {&vessel, &pot}) {
    if (p->points.empty()) continue;
    const auto draw = p == &vessel ? draw_vessels_line : draw_pots_line;
    draw(page, outline(paper, *p));
    draw(page, inside(paper, *p));
  }
  if (vessel.points.empty() || pot.points.empty()) return;
  for (const score::Remark& one : tries)
    if (one.seen) arrow(page, paper, room, vessel, pot, *one.seen);
}

}  // namespace onggi::screens
