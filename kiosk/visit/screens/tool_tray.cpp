#include "kiosk/visit/screens/tool_tray.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/contact/tool.h"
#include "kiosk/visit/screens/pen_strokes.h"

namespace onggi::screens {

using view::Rect;

namespace {

constexpr std::string_view kControl = "throw.tool.";
constexpr float kDrawn = 1.5f;    // em: side of a drawing
constexpr float kLeading = 1.2f;  // of a name on several lines

/// One on each face of a wall.
constexpr std::string_view kBareHands =
    "11,3 11,22; 13,3 13,22; arc 4.5,11 5,4 -90 90; arc 19.5,11 5,4 90 270; "
    "1,7 4.5,7; 1,15 4.5,15; 19.5,7 23,7; 19.5,15 23,15";

std::string_view drawing_of(const std::string& tool) {
  const ToolShape* const shape = find_tool_shape(tool);
  return shape != nullptr && !shape->drawing.empty() ? shape->drawing : kBareHands;
}

/// Layout of the tray: cells side by side, each with a drawing and its name; a row is as high as
/// its highest cell.
struct TrayGrid {
  std::size_t columns = 1;
  float cell = 0, drawing = 0, name = 0;  ///< Widths.
  std::vector<float> rows;
  float height = 0;
  bool fits = false;
};

view::TextStyle name_style(const Page& page) {
  auto style = page.style(view::Face::sans, page.type().body);
  style.line_height = kLeading;
  return style;
}

float between(const Page& page) { return page.type().gap * 0.5f; }

TrayGrid tray_of(const Page& page, const Desk& desk, float width, std::size_t columns) {
  const TypeScale& t = page.type();
  const std::size_t count = desk.wheel().tools.size() + 1;
  const auto style = name_style(page);
  TrayGrid grid;
  grid.columns = columns;
  grid.cell = width / static_cast<float>(columns);
  grid.drawing = std::max(t.target, kDrawn * t.body) - between(page);
  // Space before the drawing, after it, after the name, and before the next cell.
  grid.name = grid.cell - grid.drawing - 4 * between(page);
  grid.rows.assign((count + columns - 1) / columns, grid.drawing + between(page));
  grid.fits = grid.name > 0;
  for (std::size_t n = 0; n < count && grid.fits; ++n) {
    const std::string name = ToolTray::name_of(desk, n);
    const auto size = page.size(name, style, grid.name);
    grid.fits = std::max(page.longest_word(name, style), size.width) <= grid.name;
    float& row = grid.rows[n / columns];
    row = std::max(row, size.height + between(page));
  }
  grid.height = between(page) * static_cast<float>(grid.rows.size() - 1);
  for (const float row : grid.rows) grid.height += row;
  return grid;
}

/// The lowest layout that breaks no word of a name.
TrayGrid lowest_tray(const Page& page, const Desk& desk, float width) {
  TrayGrid best = tray_of(page, desk, width, 1);
  for (std::size_t columns = 2; columns <= desk.wheel().tools.size() + 1; ++columns)
    if (TrayGrid grid = tray_of(page, desk, width, columns);
        grid.fits && grid.height < best.height - 1)
      best = std::move(grid);
  return best;
}

}  // namespace

std::string ToolTray::name_of(const Desk& desk, std::size_t which) {
  const auto& tools = desk.wheel().tools;
  return desk.say("tool." + (which == 0 ? "hands" : tools[which - 1].name));
}

void ToolTray::lay_out(Column& column, const Desk& desk, std::size_t held) {
  const SceneForVisitor& wheel = desk.wheel();
  if (wheel.tools.empty()) return;
  Page& page = column.page();
  const TypeScale& t = page.type();
  const Rect strip = column.rest();
  const TrayGrid grid = lowest_tray(page, desk, strip.w);
  if (!grid.fits) page.overflowed();
  const auto style = name_style(page);
  const float air = between(page);
  const bool from_right = desk.words().right_to_left();
  float y = strip.y;
  for (std::size_t n = 0; n <= wheel.tools.size(); ++n) {
    const std::size_t place = n % grid.columns;
    if (n > 0 && place == 0) y += grid.rows[n / grid.columns - 1] + air;
    const float high = grid.rows[n / grid.columns];
    const auto turned = [&](float x, float w) {
      return from_right ? 2 * strip.x + strip.w - x - w : x;
    };
    const float left = strip.x + grid.cell * static_cast<float>(place), wide = grid.cell - air;
    const Rect button{turned(left, wide), y, wide, high};
    const std::string words = name_of(desk, n);
    const bool on = n == held;
    page.control({std::string(kControl) + std::to_string(n), button, words, on});
    page.draw(view::Box{button, t.body * 0.14f, view::with_alpha(view::kCobalt, on ? 0.10f : 0.0f),
                        on ? t.hairline * 1.5f : 0, view::kCobalt});
    const float side = grid.drawing;
    const float x = turned(left + air, side), top = y + (high - side) / 2;
    for (PenStroke stroke :
         pen_strokes(n == 0 ? kBareHands : drawing_of(wheel.tools[n - 1].name))) {
      for (auto& [px, py] : stroke) px = x + px * side / 24, py = top + py * side / 24;
      page.draw(view::Line{std::move(stroke), {view::kCobalt}, std::max(1.5f, side / 22)});
    }
    const float lines = page.size(words, style, grid.name).height;
    page.words({turned(left + 2 * air + side, grid.name), y + (high - lines) / 2, grid.name, lines},
               words, style, view::kInk);
  }
  column.space(grid.height);
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
