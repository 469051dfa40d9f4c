#include "kiosk/visit/screens/decorate_drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kiosk/visit/screens/pointing_hand.h"

namespace onggi::screens {

using decorating::Place;
using decoration::Start;
using decoration::WayTool;

namespace {

constexpr double kFullTurn = 2.0 * 3.14159265358979;
constexpr int kMarkPoints = 48;
constexpr double kFingerWidth = 0.011, kFingerOff = 0.03;  // m
constexpr double kDash = 0.011;                            // m, of a ring's start
constexpr int kDashes = 6;                                 // round the pot
constexpr double kFacing = 0.2;    // cosine from which a place counts as seen
constexpr double kHidden = 0.004;  // m
constexpr float kFaintStroke = 0.4f;
constexpr int kRowsApart = 8, kRoundABox = 48;  // where a pot's picture is looked for

const surface::Row& row_of(const decorating::DecoratedPot& pot, double along) {
  const auto& surface = pot.surface();
  return surface.row(
      std::clamp(static_cast<int>(along * 1e6) / surface::kRowHeight, 0, surface.rows() - 1));
}

/// Pixels of a metre at the pot.
double pixels_a_metre(const view::Camera& camera) {
  return 0.5 * camera.height / std::tan(0.5 * camera.fov) / camera.distance;
}

bool made_by(const Start& start, const WayTool& tool) {
  switch (tool.hand) {
    case WayTool::ring:
    case WayTool::up:
      return start.ring;
    case WayTool::line:
    case WayTool::figure:
      return !start.ring;
    case WayTool::all:
      break;
  }
  return false;
}

void short_stroke(Page& page, const SeenPot& seen, const Place& from, const Place& to) {
  const auto a = seen.pixel(from), b = seen.pixel(to);
  if (!a || !b) return;
  const float width = std::max(2.0f, page.type().body / 9.0f);
  // Seen on dark clay and on white slip.
  page.draw(view::Line{{*a, *b}, {view::with_alpha(view::kInk, 0.5f * kFaintStroke)}, 2 * width});
  page.draw(view::Line{{*a, *b}, {view::with_alpha(view::kPlaster, 2 * kFaintStroke)}, width});
}

}  // namespace

double SeenPot::front() const {
  const double turns = (0.25 * kFullTurn - camera.azimuth - angle) / kFullTurn;
  return turns - std::floor(turns);
}

std::optional<std::pair<float, float>> SeenPot::pixel(const Place& at) const {
  const surface::Row& row = row_of(pot, at.along);
  const double round = angle + kFullTurn * at.turns;
  const Vec3 place{row.radius * std::cos(round), row.height, row.radius * std::sin(round)};
  const auto pixel = camera.project(place);
  if (!pixel) return pixel;
  if (at.along <= pot.outside()) {
    const Vec3 eye = camera.eye() - place;
    if (eye.x * std::cos(round) + eye.z * std::sin(round) < kFacing * length(eye)) return {};
    return pixel;
  }
  // The near wall hides much of the inside.
  const auto seen =
      decorating::place_under(camera, pot.surface(), angle, pixel->first, pixel->second);
  if (!seen || std::abs(seen->along - at.along) > kHidden) return {};
  return pixel;
}

void draw_place(Page& page, const SeenPot& seen, const decorating::Place& at) {
  const auto middle = seen.pixel(at);
  if (!middle) return;
  const float side = page.type().body * 0.7f;
  page.draw(view::Box{{middle->first - side / 2, middle->second - side / 2, side, side},
                      side / 2,
                      view::kPlaster,
                      std::max(2.0f, side / 6),
                      view::kInk});
}

void draw_mark(Page& page, const SeenPot& seen, double along) {
  const surface::Row& row = row_of(seen.pot, along);
  view::Line line;
  for (int n = 0; n <= kMarkPoints; ++n) {
    const double angle = kFullTurn * 0.5 * n / kMarkPoints - seen.camera.azimuth;
    const auto at = seen.camera.project(
        {row.radius * std::cos(angle), row.height, row.radius * std::sin(angle)});
    if (at) line.points.push_back(*at);
  }
  // Seen on dark clay and on white slip.
  line.colors = {view::kPlaster};
  line.width = page.type().body / 3.5f;
  page.draw(line);
  line.colors = {view::kInk};
  line.width = page.type().body / 9.0f;
  page.draw(std::move(line));
  draw_place(page, seen, {along, seen.front()});  // where Enter puts it
}

void draw_finger(Page& page, const SeenPot& seen, const decorating::Example::Finger& finger) {
  const auto tip = seen.pixel(finger.at);
  if (!tip) return;
  const double scale = pixels_a_metre(seen.camera);
  const auto off = static_cast<float>(kFingerOff * scale * finger.off);
  draw_pointing_hand(page, {tip->first + off, tip->second + off},
                     static_cast<float>(kFingerWidth * scale),
                     static_cast<float>(1.0 - finger.off));
}

bool draw_starts(Page& page, const SeenPot& seen, std::span<const Start> starts) {
  const auto& pot = seen.pot;
  bool any = false;
  for (const Start& start : starts) {
    if (!made_by(start, pot.held())) continue;
    const double side = start.inside ? pot.along_of(0.0, true) - pot.outside() : pot.outside();
    const double middle = pot.along_of(start.at, start.inside);
    const double reach = start.reach * side;
    if (pot.touched(middle - reach, middle + reach)) continue;
    any = true;
    const double up = start.inside ? -1.0 : 1.0;
    const double round = kFullTurn * std::max(row_of(pot, middle).radius, 1e-3);  // m round
    const int strokes = start.ring ? kDashes : start.repeats;
    const Vec2 from = start.ring ? Vec2{-0.5 * kDash, 0.0} : start.from * side;
    const Vec2 to = start.ring ? Vec2{0.5 * kDash, 0.0} : start.to * side;
    for (int n = 0; n < strokes; ++n) {
      const double first = start.turn + static_cast<double>(n) / strokes;
      // Seen from outside, angles grow to the left.
      short_stroke(page, seen, {middle + up * from.y, first - up * from.x / round},
                   {middle + up * to.y, first - up * to.x / round});
    }
  }
  return any;
}

view::Rect seen_box(const SeenPot& seen) {
  const auto& surface = seen.pot.surface();
  float left = 1e9f, right = -1e9f, top = 1e9f, foot = -1e9f;
  for (int j = 0; j < surface.rows(); j += kRowsApart)
    for (int n = 0; n < kRoundABox; ++n) {
      const surface::Row& row = surface.row(j);
      const double angle = kFullTurn * n / kRoundABox;
      const auto at = seen.camera.project(
          {row.radius * std::cos(angle), row.height, row.radius * std::sin(angle)});
      if (!at) continue;
      left = std::min(left, at->first), right = std::max(right, at->first);
      top = std::min(top, at->second), foot = std::max(foot, at->second);
    }
  if (right < left) return {};
  return {left, top, right - left, foot - top};
}

float word_top(const Page& page, const SeenPot& seen, const std::string& words, float px) {
  const Regions& where = page.where();
  const view::Rect pot = seen_box(seen);
  const float pad = page.type().gap;
  const auto size = page.size(words, page.style(view::Face::serif, px, view::Align::centre),
                              where.pot.w - 2 * pad);
  const float lowest = where.portrait ? where.words.y : where.all.y + where.all.h;
  return std::min(pot.y + pot.h + 0.5f * pad, lowest - size.height - 1.5f * pad);
}

void draw_word(Page& page, const SeenPot& seen, const std::string& words, float px, float shown) {
  const TypeScale& t = page.type();
  const Regions& where = page.where();
  const auto style = page.style(view::Face::serif, px, view::Align::centre);
  const float pad = t.gap;
  const auto size = page.size(words, style, where.pot.w - 2 * pad);
  const float y = word_top(page, seen, words, px);
  const float middle = where.pot.x + where.pot.w / 2;
  const view::Rect box{middle - size.width / 2 - pad, y, size.width + 2 * pad, size.height + pad};
  page.draw(view::Box{box, t.body * 0.3f, view::with_alpha(view::kPlaster, 0.85f * shown), 0, {}});
  page.words({where.pot.x + pad, y + pad / 2, where.pot.w - 2 * pad, size.height}, words, style,
             view::with_alpha(view::kInk, shown));
  page.tell(y, words);
}

}  // namespace onggi::screens
