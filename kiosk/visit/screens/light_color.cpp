#include "kiosk/visit/screens/light_color.h"

#include "kiosk/collection/textures/srgb.h"

namespace onggi::screens {

view::Color display(const content::LinearColor& color) {
  const auto encode = [](float light) {
    return static_cast<float>(textures::srgb_of_light(static_cast<double>(light)));
  };
  return {encode(color[0]), encode(color[1]), encode(color[2]), 1};
}

}  // namespace onggi::screens
