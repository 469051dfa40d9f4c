#include "kiosk/picture/view/recolor.h"

#include "kiosk/picture/view/palette.h"

namespace onggi::view {

Color recolored(Color color, Recolors by) {
  for (const auto& [from, to] : by)
    if (same_hue(color, from)) return with_alpha(to, color.a);
  return color;
}

void recolor(std::vector<Item>& items, Recolors by) {
  for (Item& item : items) {
    if (auto* text = std::get_if<Text>(&item)) {
      text->color = recolored(text->color, by);
    } else if (auto* box = std::get_if<Box>(&item)) {
      box->fill = recolored(box->fill, by);
      box->border_color = recolored(box->border_color, by);
    } else if (auto* line = std::get_if<Line>(&item)) {
      for (Color& color : line->colors) color = recolored(color, by);
    }
  }
}

}  // namespace onggi::view
