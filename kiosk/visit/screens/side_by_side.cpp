#include "kiosk/visit/screens/side_by_side.h"

#include <algorithm>
#include <cmath>

#include "kiosk/visit/screens/section_drawing.h"

namespace onggi::screens {

using view::Rect;

namespace {

constexpr double kTurning = 0.8;  // rad/s: one turn in about eight seconds
// Share of a picture's height, added to the pot's, because its mouth is an ellipse.
constexpr double kEllipse = 0.5;
constexpr float kPicturesShare = 0.6f;  // of the height, if the drawing is below
constexpr double kWholeTurn = 6.283185307179586;

/// Largest scale that fits its space, pixels a metre.
double scale_in(float width, float height, double tall, double radius) {
  return std::min(static_cast<double>(width) / (2 * radius),
                  static_cast<double>(height) / (tall + kEllipse * radius));
}

/// The whole area beside the words, or above them.
Rect room_of(const Regions& where, float gap) {
  Rect room = where.page;
  // A finger turns the pots, and in portrait it reaches only their lower part.
  if (where.reach > 0 && !where.portrait) {
    const float low = std::max(where.reach + gap - room.y, 0.0f);
    room.y += low;
    room.h -= low;
  }
  if (where.portrait) {
    room.h = where.words.y - 2 * gap - room.y;
  } else {
    const float clear = where.words.w + 4 * gap;
    room.w -= clear;
    if (!where.mirrored) room.x += clear;
  }
  return room;
}

}  // namespace

SideBySide::SideBySide(const Desk& desk) {
  const ShelfCard* card = desk.shelf_card(desk.card);
  height_ = std::max(0.02, desk.made.height());
  radius_ = std::max(0.01, desk.made.points.empty() ? 0.0 : desk.made.max_radius());
  if (card == nullptr) return;
  if (!card->target.points.empty()) {
    height_ = std::max(height_, card->target.height());
    radius_ = std::max(radius_, card->target.max_radius());
  }
  if (card->vessel == nullptr) return;
  for (const auto& p : card->vessel->mesh.positions) {
    height_ = std::max(height_, card->scale * static_cast<double>(p[1]));
    radius_ = std::max(radius_, card->scale * static_cast<double>(std::hypot(p[0], p[2])));
  }
}

void SideBySide::update(const Desk& desk, const Turntable& table, double dt) {
  if (table.stands(desk.now) || desk.still()) return;
  turned_ = std::min(turned_ + kTurning * dt, kWholeTurn);
  const double angle = desk.screen().left_handed ? -turned_ : turned_;
  angle_ = std::remainder(angle, kWholeTurn);
}

float SideBySide::names_height(const Page& page, const Desk& desk, float width) const {
  const auto style = page.style(view::Face::sans, page.type().body, view::Align::centre);
  const auto height = [&](const std::string& words) {
    return page.size(words, style, width).height;
  };
  return page.type().gap +
         std::max(height(desk.label(desk.card).title), height(desk.say("result.yours")));
}

SideBySide::Places SideBySide::places(const Page& page, const Desk& desk) const {
  const float gap = page.type().gap;
  const bool shadows_fall_left = page.where().mirrored && !page.where().portrait;
  const Rect room = room_of(page.where(), gap);
  const auto of_scale = [&](double scale, float most) {
    return std::min(most, static_cast<float>(scale * (height_ + kEllipse * radius_)));
  };
  // Three side by side, or two above the drawing: whichever shows them larger.
  const float third = (room.w - 4 * gap) / 3, half = (room.w - 2 * gap) / 2;
  const float names3 = names_height(page, desk, third), names2 = names_height(page, desk, half);
  const float high3 = room.h - names3, high2 = kPicturesShare * (room.h - names2 - gap);
  const double scale3 = scale_in(third, high3, height_, radius_);
  const double scale2 = scale_in(half, high2, height_, radius_);
  const bool abreast = scale3 >= scale2;
  const float width = abreast ? third : half;
  const float tall = abreast ? of_scale(scale3, high3) : of_scale(scale2, high2);

  Places at;
  at.scale = abreast ? scale3 : scale2;
  const float names = abreast ? names3 : names2;
  const float below =
      abreast ? 0.0f
              : std::min(room.h - tall - names - gap, static_cast<float>(at.scale * height_));
  const float all = tall + names + (abreast ? 0.0f : below + gap);
  // If a portrait page extends above the reach, put the drawing up there, because visitors turn the
  // pots by finger.
  const bool low = page.where().portrait && page.where().reach > 0, drawing_over = low && !abreast;
  const float top = low ? room.y + room.h - tall - names : room.y + (room.h - all) / 2;
  const auto column = [&](int n) {
    return Rect{room.x + static_cast<float>(n) * (width + 2 * gap), top, width, tall};
  };
  // The drawing is beside the words, where no shadow falls.
  const bool drawing_first = abreast && !shadows_fall_left;
  const int first = drawing_first ? 1 : 0, second = first + 1;
  at.vessel = column(page.right_to_left() ? second : first);
  at.pot = column(page.right_to_left() ? first : second);
  at.names = top + tall;
  if (drawing_over) {
    at.section = {room.x, top - gap - below, room.w, below};
    return at;
  }
  at.section =
      abreast ? column(drawing_first ? 0 : 2) : Rect{room.x, at.names + names + gap, room.w, below};
  return at;
}

void SideBySide::name(Page& page, const Rect& over, float top, const std::string& words,
                      bool pots) const {
  const float gap = page.type().gap, sample = page.type().body * 1.4f;
  const float middle = over.x + over.w / 2, y = top + gap * 0.5f;
  const std::vector<std::pair<float, float>> line{{middle - sample, y}, {middle + sample, y}};
  (pots ? draw_pots_line : draw_vessels_line)(page, line);
  const auto style = page.style(view::Face::sans, page.type().body, view::Align::centre);
  const auto size = page.size(words, style, over.w);
  if (size.width > over.w + 1) page.overflowed();
  page.words({over.x, top + gap, over.w, size.height}, words, style, view::kInk);
}

void SideBySide::lay_out(Page& page, const Desk& desk, std::span<const score::Remark> tries) {
  const ShelfCard* card = desk.shelf_card(desk.card);
  const Places at = places(page, desk);
  half_turn_ = at.vessel.w;
  const float left = std::min(at.vessel.x, at.pot.x);
  // The frame around both keeps clear of the lines under them.
  room_ = {left, at.pot.y, std::max(at.vessel.x, at.pot.x) + at.pot.w - left,
           at.pot.h - 0.5f * page.type().gap};
  pot_at_ = view::frame_pot(page.width(), page.height(), at.pot, height_, radius_);
  vessel_at_ = pot_at_;
  vessel_at_.centre_x += at.vessel.x - at.pot.x;
  name(page, at.vessel, at.names, desk.label(desk.card).title, false);
  name(page, at.pot, at.names, desk.say("result.yours"), true);
  draw_section(page, at.section, card != nullptr ? card->target : Profile{}, desk.made, at.scale,
               tries);
}

view::PotView SideBySide::view(view::PotView pot, const Desk& desk, const Turntable& table) const {
  pot.camera = pot_at_;
  pot.wheel = false;
  pot.hands = {};
  pot.cut_away = 0;
  const double turned = angle_ + table.angle();
  pot.clay_angle += turned;
  pot.camera.elevation += table.tilt();
  const ShelfCard* card = desk.shelf_card(desk.card);
  if (card != nullptr) {
    pot.beside = view::VesselView{vessel_at_, turned};
    pot.beside->camera.elevation += table.tilt();
  }
  const auto& kiln = desk.wheel().kiln;
  if (kiln && desk.glaze >= 0) {
    pot.finish = view::Finish::fired;
    pot.glazing = {(*kiln->glazes)[static_cast<std::size_t>(desk.glaze)].look, kiln->coat};
  }
  return pot;
}

}  // namespace onggi::screens
