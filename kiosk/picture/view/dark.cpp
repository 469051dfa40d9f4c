#include "kiosk/picture/view/dark.h"

#include <utility>

#include "kiosk/picture/view/palette.h"
#include "kiosk/picture/view/recolor.h"

namespace onggi::view {

namespace {

constexpr std::pair<Color, Color> kPaler[] = {
    {kInk, kPlaster},         {kFaintInk, rgb(0xB9B2A8)},
    {kCobalt, rgb(0xA9C0EA)}, {kHeldCobalt, rgb(0xD3E0F7)},
    {kIron, rgb(0xE39A80)},   {kDeepCeladon, kCeladon},
    {kPlaster, kDark},
};

}  // namespace

Color in_the_dark(Color color) { return recolored(color, kPaler); }

void to_dark(std::vector<Item>& items, int width, int height) {
  recolor(items, kPaler);
  const Rect all{0, 0, static_cast<float>(width), static_cast<float>(height)};
  items.insert(items.begin(), Box{all, 0, kDark, 0, {}});
}

}  // namespace onggi::view
