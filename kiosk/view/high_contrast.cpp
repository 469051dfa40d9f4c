#include "kiosk/view/high_contrast.h"

#include <utility>

#include "kiosk/view/palette.h"

namespace onggi::view {

namespace {

constexpr float kHeavier = 1.6f;

constexpr std::pair<Color, Color> kDarker[] = {
    {kInk, rgb(0x000000)},        {kFaintInk, rgb(0x2B2723)}, {kCobalt, rgb(0x12244A)},
    {kHeldCobalt, rgb(0x000000)}, {kIron, rgb(0x5A1A08)},     {kDeepCeladon, rgb(0x0B3A2A)},
    {kPlaster, rgb(0xFFFFFF)},
};

bool same_hue(Color a, Color b) { return a.r == b.r && a.g == b.g && a.b == b.b; }

}  // namespace

Color in_high_contrast(Color color) {
  for (const auto& [from, to] : kDarker)
    if (same_hue(color, from)) return with_alpha(to, color.a);
  return color;
}

void to_high_contrast(std::vector<Item>& items) {
  for (Item& item : items) {
    if (auto* text = std::get_if<Text>(&item)) {
      text->color = in_high_contrast(text->color);
    } else if (auto* box = std::get_if<Box>(&item)) {
      box->fill = in_high_contrast(box->fill);
      box->border_color = in_high_contrast(box->border_color);
      box->border *= kHeavier;
    } else if (auto* line = std::get_if<Line>(&item)) {
      line->width *= kHeavier;
      for (Color& color : line->colors) {
        // A halo parts a line from clay of its own darkness, and half a halo only half.
        if (same_hue(color, kPlaster)) color.a = 1;
        color = in_high_contrast(color);
      }
    }
  }
}

}  // namespace onggi::view
