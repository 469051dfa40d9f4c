#include "kiosk/view/dark.h"

#include <utility>

#include "kiosk/view/palette.h"

namespace onggi::view {

namespace {

constexpr std::pair<Color, Color> kPaler[] = {
    {kInk, kPlaster},         {kFaintInk, rgb(0xB9B2A8)},
    {kCobalt, rgb(0xA9C0EA)}, {kHeldCobalt, rgb(0xD3E0F7)},
    {kIron, rgb(0xE39A80)},   {kDeepCeladon, kCeladon},
    {kPlaster, kDark},
};

}  // namespace

Color in_the_dark(Color color) {
  for (const auto& [from, to] : kPaler)
    if (color.r == from.r && color.g == from.g && color.b == from.b) return with_alpha(to, color.a);
  return color;
}

void to_dark(std::vector<Item>& items, int width, int height) {
  for (Item& item : items) {
    if (auto* text = std::get_if<Text>(&item)) {
      text->color = in_the_dark(text->color);
    } else if (auto* box = std::get_if<Box>(&item)) {
      box->fill = in_the_dark(box->fill);
      box->border_color = in_the_dark(box->border_color);
    } else if (auto* line = std::get_if<Line>(&item)) {
      for (Color& color : line->colors) color = in_the_dark(color);
    }
  }
  const Rect all{0, 0, static_cast<float>(width), static_cast<float>(height)};
  items.insert(items.begin(), Box{all, 0, kDark, 0, {}});
}

}  // namespace onggi::view
