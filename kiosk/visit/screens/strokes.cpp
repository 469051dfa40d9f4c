#include "kiosk/visit/screens/strokes.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

void draw_stroke(Page& page, const Points& points, view::Color color, float width) {
  if (points.size() < 2) return;
  view::Line halo{points, {view::with_alpha(view::kPlaster, 0.6f)}, width + 2.5f};
  page.draw(std::move(halo));
  page.draw(view::Line{points, {color}, width});
}

void draw_dashes(Page& page, const Points& points, view::Color color, float width, float dash) {
  float walked = 0;
  Points piece;
  bool on = true;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    auto [x, y] = points[i];
    const auto [x1, y1] = points[i + 1];
    float left = std::hypot(x1 - x, y1 - y);
    if (piece.empty() && on) piece.emplace_back(x, y);
    while (left > 1e-4f) {
      const float step = std::min(left, dash - walked);
      const float share = step / left;
      x += (x1 - x) * share;
      y += (y1 - y) * share;
      left -= step;
      walked += step;
      if (on) piece.emplace_back(x, y);
      if (walked < dash - 1e-4f) continue;
      if (on) draw_stroke(page, piece, color, width);
      piece.clear();
      walked = 0;
      on = !on;
      if (on) piece.emplace_back(x, y);
    }
  }
  if (on) draw_stroke(page, piece, color, width);
}

}  // namespace onggi::screens
