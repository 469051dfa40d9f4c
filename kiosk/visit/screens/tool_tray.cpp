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
constexpr float kDrawn = 1.5f, kDrawnLarge = 2.4f;  // em: side of a drawing
constexpr float kLeading = 1.2f;                    // of words on several lines
constexpr std::size_t kMostAbreast = 3;

/// One on each face of a wall.
constexpr std::string_view kBareHands =
    "11,3 11,22; 13,3 13,22; arc 4.5,11 5,4 -90 90; arc 19.5,11 5,4 90 270; "
    "1,7 4.5,7; 1,15 4.5,15; 19.5,7 23,7; 19.5,15 23,15";

/// A wall of two rings, and a third on its way.
constexpr std::string_view kCoil =
    "arc 12,18 9,3 0 360; arc 12,14 9,3 0 180; 3,14 3,18; 21,14 21,18; "
    "arc 12,9 9,3 20 200; 3.4,8 3.4,12; 20.6,10 20.6,14";

/// A paddle on the wall's outer face, and an anvil on the inner one.
constexpr std::string_view kPaddleAndAnvil =
    "12,2 12,22; 15,7 18,7 18,17 15,17 15,7; 18,12 23,12; arc 6,12 3.4,3.4 0 360; 6,15.4 6,21";

std::string_view drawing_of(const std::string& tool) {
  if (tool == "coil") return kCoil;
  if (tool == scene::kPaddle) return kPaddleAndAnvil;
  const ToolShape* const shape = find_tool_shape(tool);
  return shape != nullptr && !shape->drawing.empty() ? shape->drawing : kBareHands;
}

std::string id_of(const Desk& desk, std::size_t which) {
  return "tool." + (which == 0 ? "hands" : desk.wheel().tools[which - 1].name);
}

/// Layout of the tray: cells side by side, each with a drawing, its name and what it does; a row is
/// as high as its highest cell.
struct TrayGrid {
  std::size_t columns = 1;
  bool explained = true;
  float cell = 0, drawing = 0, words = 0;  ///< Widths.
  std::vector<float> rows;
  float height = 0;
  bool fits = false;
};

view::TextStyle tray_style(const Page& page) {
  auto style = page.style(view::Face::sans, page.type().body);
  style.line_height = kLeading;
  return style;
}

float between(const Page& page) { return page.type().gap * 0.5f; }

TrayGrid tray_of(const Page& page, const Desk& desk, float width, std::size_t columns,
                 bool explained) {
  const TypeScale& t = page.type();
  const std::size_t count = desk.wheel().tools.size() + 1;
  const auto style = tray_style(page);
  TrayGrid grid;
  grid.columns = columns;
  grid.explained = explained;
  grid.cell = width / static_cast<float>(columns);
  grid.drawing = std::max(t.target, (explained ? kDrawnLarge : kDrawn) * t.body) - between(page);
  // Space before the drawing, after it, after the words, and before the next cell.
  grid.words = grid.cell - grid.drawing - 4 * between(page);
  grid.rows.assign((count + columns - 1) / columns, grid.drawing + between(page));
  grid.fits = grid.words > 0;
  for (std::size_t n = 0; n < count && grid.fits; ++n) {
    float& row = grid.rows[n / columns];
    float high = between(page);
    for (const bool does : {false, true}) {
      if (does && !explained) continue;
      const std::string words = desk.say(id_of(desk, n) + (does ? "_is" : ""));
      const auto size = page.size(words, style, grid.words);
      grid.fits = grid.fits && std::max(page.longest_word(words, style), size.width) <= grid.words;
      high += size.height;
    }
    row = std::max(row, high);
  }
  grid.height = between(page) * static_cast<float>(grid.rows.size() - 1);
  for (const float row : grid.rows) grid.height += row;
  return grid;
}

/// The lowest layout that breaks no word.
TrayGrid lowest_tray(const Page& page, const Desk& desk, float width, bool explained) {
  TrayGrid best = tray_of(page, desk, width, 1, explained);
  for (std::size_t columns = 2; columns <= std::min(kMostAbreast, desk.wheel().tools.size() + 1);
       ++columns)
    if (TrayGrid grid = tray_of(page, desk, width, columns, explained);
        grid.fits && (!best.fits || grid.height < best.height - 1))
      best = std::move(grid);
  return best;
}

}  // namespace

std::string ToolTray::way_in(const Desk& desk, std::size_t held) {
  // The held tool, because a visitor chooses another one there.
  return held > 0 ? id_of(desk, held) : desk.wheel().tools.empty() ? "throw.hand" : "throw.tools";
}

std::string ToolTray::name_of(const Desk& desk, std::size_t which) {
  return desk.say(id_of(desk, which));
}

float ToolTray::least_height(const Page& page, const Desk& desk, float width) {
  return desk.wheel().tools.empty() ? 0 : lowest_tray(page, desk, width, false).height;
}

void ToolTray::lay_out(Page& page, const Rect& room, const Desk& desk, std::size_t held) {
  const SceneForVisitor& wheel = desk.wheel();
  if (wheel.tools.empty()) return;
  TrayGrid grid = lowest_tray(page, desk, room.w, true);
  // If what they do does not fit, show only the names. They are enough, and stay legible.
  if (!grid.fits || grid.height > room.h) grid = lowest_tray(page, desk, room.w, false);
  if (!grid.fits || grid.height > room.h + 0.5f) page.overflowed();
  const auto style = tray_style(page);
  const float air = between(page), width = grid.cell * static_cast<float>(grid.columns);
  const bool from_right = desk.words().right_to_left();
  float y = room.y + std::max(0.0f, (room.h - grid.height) / 2);
  for (std::size_t n = 0; n <= wheel.tools.size(); ++n) {
    const std::size_t place = n % grid.columns;
    if (n > 0 && place == 0) y += grid.rows[n / grid.columns - 1] + air;
    const float high = grid.rows[n / grid.columns];
    const auto turned = [&](float x, float w) {
      return from_right ? 2 * room.x + width - x - w : x;
    };
    const float left = room.x + grid.cell * static_cast<float>(place), wide = grid.cell - air;
    const Rect cell{turned(left, wide), y, wide, high};
    const std::string name = name_of(desk, n), does = desk.say(id_of(desk, n) + "_is");
    Button button{std::string(kControl) + std::to_string(n), "",
                  n == held ? Look::chosen : Look::outline};
    button.on = n == held;
    button.note = does;
    button.spoken = name;
    page.button(button, cell);
    const float side = grid.drawing;
    const float x = turned(left + air, side), top = y + (high - side) / 2;
    for (PenStroke stroke :
         pen_strokes(n == 0 ? kBareHands : drawing_of(wheel.tools[n - 1].name))) {
      for (auto& [px, py] : stroke) px = x + px * side / 24, py = top + py * side / 24;
      page.draw(view::Line{std::move(stroke), {view::kCobalt}, std::max(1.5f, side / 22)});
    }
    const float of_name = page.size(name, style, grid.words).height;
    const float of_does = grid.explained ? page.size(does, style, grid.words).height : 0;
    const Rect words{turned(left + 2 * air + side, grid.words), y + (high - of_name - of_does) / 2,
                     grid.words, of_name};
    page.words(words, name, style, view::kInk);
    if (grid.explained)
      page.words({words.x, words.y + of_name, words.w, of_does}, does, style,
                 n == held ? view::kInk : view::kFaintInk);  // faint is too faint on a tint
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
