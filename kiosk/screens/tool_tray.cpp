#include "kiosk/screens/tool_tray.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace onggi::screens {

using view::Rect;

namespace {

constexpr std::string_view kControl = "throw.tool.";
constexpr float kUnder = 0.4f;       // of the margin, below it
constexpr float kNameShare = 0.78f;  // of body text: a name under its drawing, not a sentence

/// A stroke of a drawing, in a square of 24 with y down.
using PenStroke = std::vector<std::pair<float, float>>;

PenStroke arc(float x, float y, float rx, float ry, double from, double to) {
  PenStroke s;
  constexpr int kParts = 20;
  for (int i = 0; i <= kParts; ++i) {
    const double a = from + (to - from) * i / kParts;
    s.emplace_back(x + rx * static_cast<float>(std::cos(a)),
                   y + ry * static_cast<float>(std::sin(a)));
  }
  return s;
}

constexpr double kPi = 3.14159265358979;

std::vector<PenStroke> drawing_of(std::string_view tool) {
  if (tool == "fingertip")
    return {{{9, 22}, {9, 8}},
            arc(12, 8, 3, 4, kPi, 2 * kPi),
            {{15, 8}, {15, 22}},
            arc(12, 7.5f, 1.6f, 2.2f, kPi, 2 * kPi)};
  if (tool == "flat_rib")
    return {{{8, 2}, {16, 2}, {16, 22}, {8, 22}, {8, 2}}, arc(12, 6, 1.4f, 1.4f, 0, 2 * kPi)};
  if (tool == "curved_rib")
    return {arc(9, 12, 9, 10, -kPi / 2, kPi / 2),
            {{9, 2}, {9, 22}},
            arc(12.5f, 12, 1.4f, 1.4f, 0, 2 * kPi)};
  if (tool == "needle")
    return {{{12, 1}, {12, 12}}, {{10.6f, 12}, {13.4f, 12}, {13.4f, 23}, {10.6f, 23}, {10.6f, 12}}};
  if (tool == "loop_trimmer")
    return {arc(12, 6, 5, 5, kPi * 0.64, kPi * 2.36),
            {{10.2f, 10.6f}, {11, 13}},
            {{13.8f, 10.6f}, {13, 13}},
            {{11, 13}, {13, 13}, {13, 23}, {11, 23}, {11, 13}}};
  if (tool == "sponge")
    return {arc(12, 13, 9.5f, 7.5f, 0, 2 * kPi), arc(8.5f, 11, 1.2f, 1, 0, 2 * kPi),
            arc(14, 9.5f, 1.2f, 1, 0, 2 * kPi), arc(12, 15, 1.2f, 1, 0, 2 * kPi),
            arc(16.5f, 14, 1, 0.9f, 0, 2 * kPi)};
  if (tool == "wire") return {{{3, 8}, {3, 16}}, {{21, 8}, {21, 16}}, arc(12, 12, 9, 2.4f, kPi, 0)};
  if (tool == "palm")
    return {arc(12, 15, 6, 7.5f, 0, kPi),
            {{6, 15}, {6, 8}},
            {{18, 15}, {18, 9}},
            arc(7.5f, 8, 1.5f, 1.6f, kPi, 2 * kPi),
            {{9, 8}, {9, 5}},
            arc(10.5f, 5, 1.5f, 1.6f, kPi, 2 * kPi),
            {{12, 5}, {12, 12}},
            arc(13.5f, 5, 1.5f, 1.6f, kPi, 2 * kPi),
            {{15, 5}, {15, 12}},
            arc(16.5f, 8, 1.5f, 1.6f, kPi, 2 * kPi)};
  // The bare hands: one on each face of a wall.
  return {{{11, 3}, {11, 22}},
          {{13, 3}, {13, 22}},
          arc(4.5f, 11, 5, 4, -kPi / 2, kPi / 2),
          arc(19.5f, 11, 5, 4, kPi / 2, 1.5 * kPi),
          {{1, 7}, {4.5f, 7}},
          {{1, 15}, {4.5f, 15}},
          {{19.5f, 7}, {23, 7}},
          {{19.5f, 15}, {23, 15}}};
}

float height_of(const TypeScale& type) {
  return std::max(type.target, type.body * 1.5f) + 1.5f * type.body * kNameShare + type.gap;
}

/// Along the foot of the pot's part of the page, and clear of its edge.
Rect strip_of(const Page& page, float height) {
  const Regions& where = page.where();
  const float w = where.all.w, h = where.all.y + where.all.h;
  const float margin = page.type().margin;
  if (where.portrait)
    return {margin, where.words.y - page.type().gap - height, w - 2 * margin, height};
  const float left = where.mirrored ? margin * 0.5f : where.words.x + where.words.w + margin * 0.7f;
  const float right = where.mirrored ? where.words.x - margin * 0.7f : w - margin * 0.5f;
  return {left, h - margin * kUnder - height, right - left, height};
}

}  // namespace

float ToolTray::room(const Wheel& wheel, const TypeScale& type) {
  return wheel.tools.empty() ? 0 : height_of(type) + type.margin * kUnder + type.gap;
}

void ToolTray::lay_out(Page& page, const Desk& desk, std::size_t held) {
  const Wheel wheel = desk.wheel();
  const TypeScale& t = page.type();
  if (wheel.tools.empty()) return;
  const float height = height_of(t);
  const Rect strip = strip_of(page, height);
  const auto count = static_cast<float>(wheel.tools.size() + 1);
  const float width = std::min(strip.w / count, t.body * 5.5f);
  const float from = strip.x + (strip.w - width * count) / 2;
  const auto style = page.style(view::Face::sans, t.body * kNameShare, view::Align::centre);
  for (std::size_t n = 0; n <= wheel.tools.size(); ++n) {
    const std::string name = n == 0 ? "hands" : wheel.tools[n - 1].name;
    const Rect cell{from + width * static_cast<float>(n), strip.y, width, height};
    const Rect button{cell.x + 2, cell.y, cell.w - 4, cell.h};
    page.control(std::string(kControl) + std::to_string(n), button);
    const bool on = n == held;
    page.draw(view::Box{button, t.body * 0.2f, view::with_alpha(view::kCobalt, on ? 0.10f : 0.0f),
                        on ? t.hairline * 2 : 0, view::kCobalt});
    const std::string words = desk.say("tool." + name);
    const auto size = page.size(words, style, button.w);
    const float side = height - size.height - t.gap;
    if (size.width > button.w + 1 || side < t.target * 0.7f) page.overflowed();
    const float x = cell.x + (cell.w - side) / 2, y = cell.y + t.gap * 0.4f;
    for (PenStroke stroke : drawing_of(name)) {
      for (auto& [px, py] : stroke) px = x + px * side / 24, py = y + py * side / 24;
      page.draw(view::Line{std::move(stroke), {view::kCobalt}, std::max(1.5f, side / 22)});
    }
    page.words({button.x, cell.y + cell.h - size.height - t.gap * 0.3f, button.w, size.height},
               words, style, view::kInk);
  }
}

std::optional<std::size_t> ToolTray::of_control(const std::string& control) {
  if (!control.starts_with(kControl)) return std::nullopt;
  std::size_t n = 0;
  const char* end = control.data() + control.size();
  const auto read = std::from_chars(control.data() + kControl.size(), end, n);
  return read.ec == std::errc() && read.ptr == end ? std::optional(n) : std::nullopt;
}

}  // namespace onggi::screens
