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
// Of body text: names are as legible as any words, but on an upright screen, where they would take
// a row more from the pot.
constexpr float kUprightName = 0.78f;

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

/// How the tray is set: rows of cells, in each a drawing with its name under it.
struct TrayGrid {
  std::size_t per_row = 1, rows = 1;
  float cell = 0, side = 0, name = 0;  ///< Width; of a drawing; height of the highest name.
  bool fits = false;
};

/// Of the words in `name`, set on their own.
float longest_word(const Page& page, const std::string& name, const view::TextStyle& style) {
  float longest = 0;
  for (std::size_t begin = 0; begin < name.size();) {
    const std::size_t end = std::min(name.find(' ', begin), name.size());
    longest = std::max(longest, page.size(name.substr(begin, end - begin), style, -1).width);
    begin = end + 1;
  }
  return longest;
}

float name_px(const Page& page) {
  return page.type().body * (page.where().portrait ? kUprightName : 1.0f);
}

/// The fewest rows in `width` pixels in which no word of a name is broken.
TrayGrid tray_grid(const Page& page, const Desk& desk, float width) {
  const TypeScale& t = page.type();
  const std::size_t count = desk.wheel().tools.size() + 1;
  const auto style = page.style(view::Face::sans, name_px(page), view::Align::centre);
  TrayGrid grid;
  for (grid.rows = 1; grid.rows <= count; ++grid.rows) {
    grid.per_row = (count + grid.rows - 1) / grid.rows;
    grid.cell = std::min(width / static_cast<float>(grid.per_row), t.body * 5.5f);
    grid.side = std::max(t.target, t.body * 1.5f);
    grid.name = 0;
    grid.fits = grid.side <= grid.cell - 4;
    for (std::size_t n = 0; n < count; ++n) {
      const std::string name = ToolTray::name_of(desk, n);
      grid.fits = grid.fits && longest_word(page, name, style) <= grid.cell - 5;
      grid.name = std::max(grid.name, page.size(name, style, grid.cell - 4).height);
    }
    if (grid.fits) break;
  }
  return grid;
}

}  // namespace

std::string ToolTray::name_of(const Desk& desk, std::size_t which) {
  const auto& tools = desk.wheel().tools;
  return desk.say("tool." + (which == 0 ? "hands" : tools[which - 1].name));
}

void ToolTray::lay_out(Column& column, const Desk& desk, std::size_t held) {
  const Wheel& wheel = desk.wheel();
  if (wheel.tools.empty()) return;
  Page& page = column.page();
  const TypeScale& t = page.type();
  const Rect strip = column.rest();
  const TrayGrid grid = tray_grid(page, desk, strip.w);
  if (!grid.fits) page.overflowed();
  const float height = grid.side + grid.name + t.gap;
  const auto style = page.style(view::Face::sans, name_px(page), view::Align::centre);
  for (std::size_t n = 0; n <= wheel.tools.size(); ++n) {
    const auto row = static_cast<float>(n / grid.per_row);
    auto place = static_cast<float>(n % grid.per_row);
    if (desk.words().right_to_left()) place = static_cast<float>(grid.per_row) - 1 - place;
    const Rect cell{strip.x + grid.cell * place, strip.y + row * (height + t.gap * 0.5f), grid.cell,
                    height};
    const Rect button{cell.x + 2, cell.y, cell.w - 4, cell.h};
    const bool on = n == held;
    page.control({std::string(kControl) + std::to_string(n), button, name_of(desk, n), on});
    page.draw(view::Box{button, t.body * 0.2f, view::with_alpha(view::kCobalt, on ? 0.10f : 0.0f),
                        on ? t.hairline * 2 : 0, view::kCobalt});
    const float x = cell.x + (cell.w - grid.side) / 2, y = cell.y + t.gap * 0.4f;
    for (PenStroke stroke : drawing_of(n == 0 ? "hands" : wheel.tools[n - 1].name)) {
      for (auto& [px, py] : stroke) px = x + px * grid.side / 24, py = y + py * grid.side / 24;
      page.draw(view::Line{std::move(stroke), {view::kCobalt}, std::max(1.5f, grid.side / 22)});
    }
    const std::string words = name_of(desk, n);
    const float lines = page.size(words, style, button.w).height;
    page.words({button.x, y + grid.side + t.gap * 0.2f, button.w, lines}, words, style, view::kInk);
  }
  const auto rows = static_cast<float>(grid.rows);
  column.space(rows * height + (rows - 1) * t.gap * 0.5f);
  column.check();
}

std::optional<std::size_t> ToolTray::of_control(const std::string& control) {
  if (!control.starts_with(kControl)) return std::nullopt;
  std::size_t n = 0;
  const char* end = control.data() + control.size();
  const auto read = std::from_chars(control.data() + kControl.size(), end, n);
  return read.ec == std::errc() && read.ptr == end ? std::optional(n) : std::nullopt;
}

}  // namespace onggi::screens
