#include "kiosk/picture/view/high_contrast.h"

#include <utility>

#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/recolor.h"

namespace onggi::view {

namespace {

constexpr float kHeavier = 1.6f;

constexpr std::pair<Color, Color> kDarker[] = {
    {kInk, rgb(0x000000)},        {kFaintInk, rgb(0x2B2723)}, {kCobalt, rgb(0x12244A)},
    {kHeldCobalt, rgb(0x000000)}, {kIron, rgb(0x5A1A08)},     {kDeepCeladon, rgb(0x0B3A2A)},
    {kPlaster, rgb(0xFFFFFF)},
};

}  // namespace

Color in_high_contrast(Color color) { return recolored(color, kDarker); }

void to_high_contrast(std::vector<Item>& items) {
  for (Item& item : items) {
    if (auto* box = std::get_if<Box>(&item)) {
      box->border *= kHeavier;
    } else if (auto* line = std::get_if<Line>(&item)) {
      line->width *= kHeavier;
      // A halo separates a line from clay of the same darkness; half a halo is not enough.
      for (Color& color : line->colors)
        if (same_hue(color, kPlaster)) color.a = 1;
    }
  }
  recolor(items, kDarker);
}

}  // namespace onggi::view
