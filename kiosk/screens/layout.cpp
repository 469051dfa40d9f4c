#include "kiosk/screens/layout.h"

#include <algorithm>
#include <cmath>

#include "kiosk/view/type_scale.h"

namespace onggi::screens {

TypeScale type_scale(const settings::Exhibit::Screen& screen, int width, int height, float shrink) {
  const double w = width, h = height, short_side = std::min(w, h);
  const double px_per_mm = std::sqrt(w * w + h * h) / std::max(screen.diagonal_mm, 100.0);
  const float body =
      view::TypeScale::for_screen(width, height, screen.diagonal_mm, screen.viewing_distance_mm)
          .body();
  const view::TypeScale steps(std::min(body, static_cast<float>(short_side / 28.0)) * shrink);

  TypeScale t;
  t.body = steps.body();
  t.lead = steps.px(1);
  t.title = steps.px(2);
  t.display = steps.px(3);
  t.target = static_cast<float>(std::clamp(15.0 * px_per_mm, 28.0, short_side / 10.0));
  t.gap = t.body * 0.5f;
  t.margin = static_cast<float>(std::round(short_side * 0.06));
  t.hairline = static_cast<float>(std::max(1.0, std::round(short_side / 720.0)));
  return t;
}

Regions regions(int width, int height, float margin, bool mirrored) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  Regions r;
  r.page = {margin, margin, w - 2 * margin, h - 2 * margin};
  r.portrait = height > width;
  r.mirrored = mirrored;
  if (r.portrait) {
    r.pot = {margin * 2, margin * 1.5f, w - 4 * margin, std::round(h * 0.52f) - margin * 1.5f};
    const float top = r.pot.y + r.pot.h + margin * 1.5f;
    r.words = {margin, top, w - 2 * margin, h - margin - top};
    return r;
  }
  r.words = {margin, margin, std::round(w * 0.365f), h - 2 * margin};
  // The axis on the vertical third: the pot's half width is what is left beside it on both sides.
  const float axis = w * 2.0f / 3.0f;
  const float half = std::min(axis - (r.words.x + r.words.w + margin), w - axis);
  // Air above the rim; below the foot, the wheel.
  r.pot = {axis - half, margin * 1.2f, 2 * half, h - margin * 3.4f};
  if (mirrored) {
    r.words.x = w - r.words.x - r.words.w;
    r.pot.x = w - r.pot.x - r.pot.w;
  }
  return r;
}

}  // namespace onggi::screens
