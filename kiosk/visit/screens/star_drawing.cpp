#include "kiosk/visit/screens/star_drawing.h"

#include <cmath>

#include "kiosk/visit/screens/strokes.h"

namespace onggi::screens {

namespace {

constexpr float kPitch = 1.3f;   // of a star's size
constexpr float kWaist = 0.46f;  // inner radius of the outer: plump enough for a small star
constexpr float kTenth = 3.14159265f / 5;

/// Ten corners and the first again, a point upwards.
Points star(float x, float y, float radius) {
  Points corners;
  for (int i = 0; i <= 10; ++i) {
    const float r = i % 2 == 0 ? radius : radius * kWaist;
    const float angle = kTenth * static_cast<float>(i);
    corners.emplace_back(x + r * std::sin(angle), y - r * std::cos(angle));
  }
  return corners;
}

}  // namespace

float stars_width(float size) { return size * (1 + (kStars - 1) * kPitch); }

void draw_stars(Page& page, const view::Rect& at, int full, float size, float opacity) {
  const view::Color ink = view::with_alpha(view::kIron, opacity);
  const float radius = 0.5f * size, y = at.y + at.h / 2 + 0.05f * size;
  for (int i = 0; i < kStars; ++i) {
    const float along = radius + static_cast<float>(i) * size * kPitch;
    const float x = page.right_to_left() ? at.x + at.w - along : at.x + along;
    if (i >= full) {
      const float pen = std::max(1.4f, 0.07f * size);
      page.draw(view::Line{star(x, y, radius - pen), {ink}, pen});
      continue;
    }
    // Lines only: three stars within each other leave no gap between them.
    const float pen = 0.26f * radius;
    for (const float within : {0.84f, 0.5f, 0.2f})
      page.draw(view::Line{star(x, y, within * radius), {ink}, pen});
  }
}

}  // namespace onggi::screens
