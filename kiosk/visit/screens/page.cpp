#include "kiosk/visit/screens/page.h"

#include <algorithm>
#include <cmath>

#include "kiosk/visit/screens/pen_strokes.h"
#include "kiosk/visit/screens/star_drawing.h"

namespace onggi::screens {

using view::Align;
using view::Color;
using view::Face;
using view::Rect;

namespace {
// Pango rounds to its own units. A line measured to the pixel must not break because of that.
constexpr float kSlack = 4.0f;
constexpr float kButtonLine = 1.2f;
// Titles of Arabic are in Naskh, whose letters are 0.87 to 0.93 of the other faces' at one size.
constexpr float kNaskh = 1.12f;
constexpr float kTint = 0.12f;  // of cobalt, on a choice that is on
}  // namespace

view::TextStyle Page::style(Face face, float px, Align align) const {
  view::TextStyle s;
  s.face = face;
  s.px = px * (face == Face::serif && sheet_.language == "ar" ? kNaskh : 1.0f);
  s.align = align;
  s.line_height = face == Face::serif ? 1.22f : 1.4f;
  s.language = sheet_.language;
  s.right_to_left = sheet_.right_to_left;
  return s;
}

view::TextMeasure::Size Page::size(const std::string& words, const view::TextStyle& style,
                                   float at_most) const {
  return measuring_(words, style, at_most);
}

float Page::longest_word(const std::string& words, const view::TextStyle& style) const {
  float longest = 0;
  if (style.language.starts_with("ja") || style.language.starts_with("zh")) return longest;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    longest = std::max(longest, size(words.substr(begin, end - begin), style, -1).width);
    begin = end + 1;
  }
  return longest;
}

void Page::words(const Rect& box, const std::string& words, const view::TextStyle& style,
                 Color color) {
  items_.push_back(view::Text{box, words, style, color});
}

namespace {
struct Padding {
  float x, y;
};
Padding padding(const Button& button, const TypeScale& t) {
  if (button.look == Look::quiet || button.look == Look::plain) return {0, t.body * 0.2f};
  return {t.body * (button.tight ? 0.35f : 0.7f), t.body * 0.32f};
}
constexpr float kSketch = 1.35f;  // of the least touch target
float swatch_width(const TypeScale& t) { return t.body * 1.45f; }
view::TextStyle button_style(const Page& page, const Button& button) {
  view::TextStyle s = page.style(Face::sans, page.type().body, Align::centre);
  s.line_height = kButtonLine;
  if (!button.language.empty()) s.language = button.language;
  return s;
}
}  // namespace

view::TextMeasure::Size Page::size(const Button& button, float at_most) const {
  if (!button.drawing.empty()) return {type().target, type().target};
  if (!button.sketch.empty()) return {type().target * kSketch, type().target * kSketch};
  const Padding pad = padding(button, type());
  const auto style = button_style(*this, button);
  const float aside = button.swatch ? swatch_width(type()) : 0;
  const auto room = [&](const std::string& words, float width) {
    auto text = size(words, style, -1);
    if (text.width + kSlack + 2 * pad.x + aside > width)
      text = size(words, style, width - 2 * pad.x - kSlack - aside);
    return view::TextMeasure::Size{std::max(text.width + kSlack + 2 * pad.x + aside, type().target),
                                   std::max(text.height + 2 * pad.y, type().target)};
  };
  if (button.other.empty()) return room(button.room.empty() ? button.words : button.room, at_most);
  const auto a = room(button.words, at_most / 2), b = room(button.other, at_most / 2);
  return {2 * std::max(a.width, b.width), std::max(a.height, b.height)};
}

void Page::button(const Button& button, const Rect& rect) {
  if (!button.id.empty())
    touched({button.id, rect, button.spoken.empty() ? button.words : button.spoken, button.on,
             button.note});
  if (!button.other.empty()) {
    switch_halves(button, rect);
  } else if (!button.drawing.empty()) {
    drawn(button, rect);
  } else {
    const Padding pad = padding(button, type());
    const auto style = button_style(*this, button);
    const float aside = button.swatch ? swatch_width(type()) : 0;
    const float inner = rect.w - 2 * pad.x - aside;
    const auto text = size(button.words, style, inner);
    const Rect box{rect.x + pad.x + (right_to_left() ? 0 : aside),
                   rect.y + (rect.h - text.height) / 2, inner, text.height};
    const bool held = sheet_.attention.pressed == button.id && !button.id.empty();
    const float radius = type().body * 0.14f;
    Color ink = view::kCobalt;
    switch (button.look) {
      case Look::plain:
        ink = view::kInk;
        break;
      case Look::resting:
        ink = view::kFaintInk;
        draw(view::Box{
            rect, radius, {0, 0, 0, 0}, type().hairline, view::with_alpha(view::kFaintInk, 0.5f)});
        break;
      case Look::solid:
        ink = view::kPlaster;
        draw(view::Box{rect, radius, held ? view::kHeldCobalt : view::kCobalt, 0, {}});
        break;
      case Look::outline:
      case Look::chosen:
      case Look::called: {
        const float tint = held ? 0.18f : button.look == Look::outline ? 0.0f : kTint;
        const float line = button.look == Look::outline ? 1.5f : 3.0f;
        draw(view::Box{rect, radius, view::with_alpha(view::kCobalt, tint), type().hairline * line,
                       view::kCobalt});
        break;
      }
      case Look::quiet: {
        const bool on = button.on.value_or(false);
        if (held || on)
          draw(view::Box{rect, radius, view::with_alpha(view::kCobalt, 0.14f), 0, {}});
        const float y = std::round(box.y + box.h) + type().hairline * 1.5f;
        const float x = box.x + (inner - text.width) / 2;
        const float line = type().hairline * (on ? 3.0f : 1.0f);
        draw(view::Box{{x, y, text.width, line}, 0, view::kCobalt, 0, {}});
        break;
      }
    }
    if (button.swatch) {
      const float w = type().body * 1.15f, h = std::min(rect.h * 0.76f, type().body * 1.7f);
      const float at = right_to_left() ? rect.x + rect.w - pad.x * 0.8f - w : rect.x + pad.x * 0.8f;
      test_tile({at, rect.y + (rect.h - h) / 2, w, h}, *button.swatch);
    }
    if (!button.sketch.empty()) sketched(button, rect);
    if (!button.words.empty()) words(box, button.words, style, ink);
    if (button.look == Look::chosen) tick(rect);
  }
  if (!button.id.empty() && sheet_.attention.focused == button.id) focus_ring(rect);
}

/// As potters try a glaze: on a tile whose foot stays bare.
void Page::test_tile(const Rect& r, Color glaze) {
  const float line = std::max(1.0f, type().hairline), round = r.w * 0.14f, foot = r.h * 0.24f;
  draw(view::Box{r, round, view::kDryClay, line, view::with_alpha(view::kInk, 0.6f)});
  const Rect coat{r.x + line, r.y + line, r.w - 2 * line, r.h - foot - line};
  draw(view::Box{coat, round, glaze, 0, {}});
  // Thicker where it ran to, and a shine from the window.
  draw(view::Box{{coat.x, coat.y + coat.h - foot * 0.35f, coat.w, foot * 0.35f},
                 foot * 0.17f,
                 view::with_alpha(view::kInk, 0.18f),
                 0,
                 {}});
  draw(view::Box{{coat.x + coat.w * 0.2f, coat.y + coat.h * 0.15f, coat.w * 0.16f, coat.h * 0.5f},
                 coat.w * 0.08f,
                 {1, 1, 1, 0.45f},
                 0,
                 {}});
}

void Page::drawn(const Button& button, const Rect& rect) {
  if (sheet_.attention.pressed == button.id)
    draw(view::Box{rect, rect.w / 2, view::with_alpha(view::kCobalt, 0.14f), 0, {}});
  const float side = std::min(rect.w, rect.h), unit = side / 24;
  const float x = rect.x + (rect.w - side) / 2, y = rect.y + (rect.h - side) / 2;
  for (PenStroke stroke : pen_strokes(button.drawing)) {
    for (auto& [px, py] : stroke) px = x + px * unit, py = y + py * unit;
    draw(view::Line{std::move(stroke), {view::kCobalt}, std::max(1.5f, unit * 1.1f)});
  }
}

void Page::sketched(const Button& button, const Rect& rect) {
  const float side = 0.8f * std::min(rect.w, rect.h);
  const float x = rect.x + (rect.w - side) / 2, y = rect.y + (rect.h - side) / 2;
  for (auto points : button.sketch) {
    for (auto& [px, py] : points) px = x + px * side, py = y + py * side;
    draw(view::Line{std::move(points), {view::kCobalt}, std::max(1.2f, side / 40)});
  }
}

void Page::switch_halves(const Button& button, const Rect& rect) {
  const float radius = type().body * 0.14f, half = rect.w / 2;
  const auto style = button_style(*this, button);
  const bool held = sheet_.attention.pressed == button.id && !button.id.empty();
  draw(view::Box{rect, radius, view::with_alpha(view::kCobalt, held ? 0.18f : 0.0f),
                 type().hairline * 1.5f, view::kCobalt});
  for (const bool second : {false, true}) {
    const Rect side{rect.x + (second != right_to_left() ? half : 0), rect.y, half, rect.h};
    const bool on = second == button.other_on;
    if (on)
      draw(view::Box{side, radius, view::with_alpha(view::kCobalt, kTint), type().hairline * 3.0f,
                     view::kCobalt});
    const std::string& text = second ? button.other : button.words;
    const float pad = type().body * 0.35f;
    const auto text_size = size(text, style, side.w - 2 * pad);
    words({side.x + pad, side.y + (side.h - text_size.height) / 2, side.w - 2 * pad,
           text_size.height},
          text, style, view::kCobalt);
    if (on) tick(side);
  }
}

void Page::tick(const Rect& rect) {
  // No larger than the least space beside words, so that it hides none, and needs no room of its
  // own: nothing moves when a choice is made.
  const float d = type().body * 0.7f, unit = d / 24;
  const float x = (right_to_left() ? rect.x : rect.x + rect.w) - d / 2, y = rect.y - d / 2;
  draw(view::Box{{x, y, d, d}, d / 2, view::kCobalt, 0, {}});
  draw(view::Line{{{x + 6.5f * unit, y + 12.5f * unit},
                   {x + 10.5f * unit, y + 16.5f * unit},
                   {x + 17.5f * unit, y + 8 * unit}},
                  {view::kPlaster},
                  std::max(1.5f, 3 * unit)});
}

void Page::touched(const Control& control) {
  if (!control.by_keys && control.rect.y < where().reach - 0.5f) overflow_ = out_of_reach_ = true;
  controls_.push_back(control);
}

void Page::control(const Control& control) {
  touched(control);
  if (sheet_.attention.pressed == control.id)
    draw(view::Box{
        control.rect, type().body * 0.14f, view::with_alpha(view::kCobalt, 0.08f), 0, {}});
  if (!focused(control.id)) return;
  // Drawn over a picture, so a pale edge shows the ring on a dark one, too.
  const float line = std::max(3.0f, type().hairline * 3), out = type().gap * 0.4f + 0.7f * line;
  const Rect& r = control.rect;
  draw(view::Box{{r.x - out, r.y - out, r.w + 2 * out, r.h + 2 * out},
                 type().body * 0.3f,
                 {0, 0, 0, 0},
                 2.4f * line,
                 view::kPlaster});
  focus_ring(control.rect);
}

std::vector<std::string> Page::told() const {
  auto ordered = told_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> out;
  for (auto& [y, words] : ordered) out.push_back(std::move(words));
  return out;
}

void Page::focus_ring(const Rect& rect) {
  const float out = type().gap * 0.4f, line = std::max(3.0f, type().hairline * 3);
  draw(view::Box{{rect.x - out, rect.y - out, rect.w + 2 * out, rect.h + 2 * out},
                 type().body * 0.3f,
                 {0, 0, 0, 0},
                 line,
                 view::kInk});
}

float Column::line_width(float px) const {
  return std::min(box_.w, px * 0.52f * 55.0f);  // 55 characters of about half an em
}

float Column::height_of(const std::string& words, float px) const {
  if (words.empty()) return 0;
  return page_.size(words, page_.style(Face::sans, px), line_width(px)).height;
}

void Column::text(const std::string& words, float px, Face face, Color color, Align align) {
  if (words.empty()) return;
  const auto style = page_.style(face, px, align);
  const float width = line_width(px);
  const auto size = page_.size(words, style, width);
  if (size.width > width + 1) page_.overflowed();
  page_.words({turned(box_.x, width), top_, width, size.height}, words, style, color);
  page_.tell(top_, words);
  top_ += size.height;
  check();
}

float Column::flow(const std::vector<Button>& row, float indent, float end,
                   std::vector<Placed>& placed) const {
  const float gap = page_.type().gap;
  float x = indent, y = 0, row_height = 0;
  std::size_t row_begin = placed.size();
  const auto level = [&] {
    for (; row_begin < placed.size(); ++row_begin) placed[row_begin].rect.h = row_height;
  };
  for (const Button& button : row) {
    const float widest = end - indent;
    const float spread = button.look == Look::quiet ? gap * 2 : gap;
    const auto size = page_.size(button, widest);
    if (size.width > widest + 1) page_.overflowed();
    if (x > indent && x + size.width > end) {
      level();
      x = indent;
      y += row_height + gap;
      row_height = 0;
    }
    placed.push_back({button, {box_.x + x, y, size.width, size.height}});
    row_height = std::max(row_height, size.height);
    x += size.width + spread;
  }
  level();
  return y + row_height;
}

void Column::place(std::vector<Placed>& placed, float y, const std::string& caption,
                   float caption_width) {
  if (placed.empty()) return;
  if (!caption.empty()) {
    const auto style = page_.style(Face::sans, page_.type().body);
    const auto size = page_.size(caption, style, -1);
    page_.words({turned(box_.x, caption_width), y + (placed.front().rect.h - size.height) / 2,
                 caption_width, size.height},
                caption, style, view::kFaintInk);
  }
  for (Placed& p : placed) {
    p.rect.y += y;
    p.rect.x = turned(p.rect.x, p.rect.w);
    page_.button(p.button, p.rect);
  }
  check();
}

void Column::buttons(const std::vector<Button>& row, const std::string& caption,
                     float caption_width) {
  std::vector<Placed> placed;
  const float indent = caption.empty() ? 0 : caption_width + page_.type().gap;
  const float height = flow(row, indent, box_.w, placed);
  into_reach();
  top_ += height;
  place(placed, top_ - height, caption, caption_width);
}

void Column::foot_buttons(std::vector<Button> row) {
  std::vector<Placed> placed;
  const auto corner = std::ranges::find_if(row, [](const Button& b) { return !b.drawing.empty(); });
  if (corner == row.end()) {
    foot_ -= flow(row, 0, box_.w, placed);
    return place(placed, foot_, {}, 0);
  }
  const Button drawn = *corner;
  row.erase(corner);
  const auto size = page_.size(drawn, box_.w);
  const float aside = size.width + 2 * page_.type().gap;
  const bool first = page_.where().mirrored == page_.right_to_left();
  const float high =
      std::max(flow(row, first ? aside : 0, first ? box_.w : box_.w - aside, placed), size.height);
  placed.push_back({drawn,
                    {first ? box_.x : box_.x + box_.w - size.width, high - size.height, size.width,
                     size.height}});
  foot_ -= high;
  place(placed, foot_, {}, 0);
}

std::size_t Column::abreast(const std::vector<Button>& cells) const {
  // Wide enough for the words in one line. Break them only as a last resort.
  float widest = 0;
  for (const Button& cell : cells) widest = std::max(widest, page_.size(cell, box_.w).width);
  const float gap = page_.type().gap;
  std::size_t abreast = std::max<std::size_t>(1, cells.size());
  const auto width = [&] {
    const auto n = static_cast<float>(abreast);
    return (box_.w - (n - 1) * gap) / n;
  };
  while (abreast > 1 && widest > width() + 1) abreast = (abreast + 1) / 2;
  return abreast;
}

void Column::foot_grid(const std::vector<Button>& cells, float height, bool mirrored) {
  const float gap = page_.type().gap;
  const std::size_t abreast = this->abreast(cells);
  const auto n = static_cast<float>(abreast);
  const float width = (box_.w - (n - 1) * gap) / n;
  float tall = height;
  for (const Button& cell : cells) {
    const auto size = page_.size(cell, abreast > 1 ? box_.w : width);
    if (size.width > width + 1) page_.overflowed();
    tall = std::max(tall, size.height);
  }
  const std::size_t rows = (std::max<std::size_t>(1, cells.size()) + abreast - 1) / abreast;
  foot_ -= static_cast<float>(rows) * (tall + gap) - gap;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].id.empty() && cells[i].look != Look::resting) continue;
    const std::size_t place = mirrored ? abreast - 1 - i % abreast : i % abreast;
    page_.button(cells[i], {box_.x + static_cast<float>(place) * (width + gap),
                            foot_ + static_cast<float>(i / abreast) * (tall + gap), width, tall});
  }
  check();
}

void Column::stars(int full, const std::string& words) {
  const auto style = page_.style(Face::sans, page_.type().body);
  const auto size = page_.size(words, style, -1);
  const float star = page_.type().body * 1.35f, line = std::max(size.height, star);
  draw_stars(page_, {box_.x, top_, box_.w, line}, full, star);
  float x = box_.x + stars_width(star) + page_.type().gap;
  const float room = size.width + kSlack;
  if (x + room > box_.x + box_.w) {  // under them
    x = box_.x;
    top_ += line;
    if (room > box_.w) page_.overflowed();
  }
  page_.words({turned(x, room), top_ + (line - size.height) / 2, room, size.height}, words, style,
              view::kFaintInk);
  page_.tell(top_, words);
  top_ += line;
  check();
}

void Column::check() const {
  if (top_ > foot_ + 0.5f) page_.overflowed();
}

}  // namespace onggi::screens
