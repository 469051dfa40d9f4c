#include "kiosk/visit/screens/hands_drawing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace onggi::screens {

using content::HandsDrawn;

namespace {

using Points = std::vector<std::pair<float, float>>;

// The drawing's area is 1 by 1 from the top left; its content is mirrored around 0.5.
class Slip {
 public:
  Slip(Page& page, const view::Rect& box)
      : page_(page),
        side_(std::min(box.w, box.h)),
        x_(box.x),
        y_(box.y + (box.h - side_) / 2),
        pen_(std::max(1.4f, side_ * 0.018f)) {}

  void line(Points points, view::Color color, float thick = 1) {
    for (auto& [x, y] : points) x = x_ + x * side_, y = y_ + y * side_;
    page_.draw(view::Line{std::move(points), {color}, pen_ * thick});
  }
  void both(const Points& points, view::Color color, float thick = 1) {
    line(points, color, thick);
    Points other = points;
    for (auto& [x, y] : other) x = 1 - x;
    line(other, color, thick);
  }
  // A mitten with fingertips at (x, y) that point along the unit vector (along_x, along_y), with
  // the thumb on its left or right.
  void hand(float x, float y, float along_x, float along_y, float thumb) {
    constexpr std::pair<float, float> kMitten[] = {
        {-0.30f, -0.06f}, {-0.17f, -0.075f}, {-0.06f, -0.06f}, {-0.01f, -0.03f}, {0.0f, 0.0f},
        {-0.02f, 0.035f}, {-0.08f, 0.05f},   {-0.12f, 0.055f}, {-0.08f, 0.10f},  {-0.10f, 0.13f},
        {-0.14f, 0.125f}, {-0.20f, 0.075f},  {-0.30f, 0.065f}};
    Points points;
    for (const auto& [forward, aside] : kMitten)
      points.emplace_back(x + forward * along_x - thumb * aside * along_y,
                          y + forward * along_y + thumb * aside * along_x);
    line(points, view::kInk, 1.3f);
  }
  void arrow(Points way) {
    const auto [x, y] = way.back();
    const auto [from_x, from_y] = way[way.size() - 2];
    const float length = std::hypot(x - from_x, y - from_y);
    const float u = (x - from_x) / length * 0.06f, v = (y - from_y) / length * 0.06f;
    line(std::move(way), view::kDeepCeladon, 1.6f);
    line({{x - u - 0.7f * v, y - v + 0.7f * u}, {x, y}, {x - u + 0.7f * v, y - v - 0.7f * u}},
         view::kDeepCeladon, 1.6f);
  }
  void wheel() { line({{0.14f, 0.93f}, {0.86f, 0.93f}}, view::kFaintInk, 1.6f); }
  void cylinder() { both({{0.5f, 0.90f}, {0.33f, 0.90f}, {0.33f, 0.36f}}, view::kFaintInk, 1.6f); }
  // A low wall of three rings, and half of a fourth.
  void rings() {
    for (const float y : {0.86f, 0.76f, 0.66f})
      line({{0.28f, y}, {0.25f, y - 0.05f}, {0.28f, y - 0.1f}}, view::kFaintInk, 1.6f),
          line({{0.72f, y}, {0.75f, y - 0.05f}, {0.72f, y - 0.1f}}, view::kFaintInk, 1.6f),
          line({{0.28f, y - 0.1f}, {0.72f, y - 0.1f}}, view::kFaintInk, 1.2f);
    line({{0.28f, 0.86f}, {0.28f, 0.90f}, {0.72f, 0.90f}, {0.72f, 0.86f}}, view::kFaintInk, 1.6f);
    line({{0.46f, 0.54f}, {0.70f, 0.52f}}, view::kInk, 3.2f);
  }
  void jar() {
    both({{0.5f, 0.90f},
          {0.37f, 0.90f},
          {0.29f, 0.78f},
          {0.25f, 0.66f},
          {0.26f, 0.54f},
          {0.32f, 0.44f},
          {0.38f, 0.36f}},
         view::kFaintInk, 1.6f);
  }

 private:
  Page& page_;
  float side_, x_, y_, pen_;
};

void draw_lump(Slip& slip) {
  slip.both({{0.5f, 0.52f}, {0.40f, 0.54f}, {0.33f, 0.61f}, {0.30f, 0.74f}, {0.28f, 0.90f}},
            view::kFaintInk, 1.6f);
  slip.hand(0.29f, 0.72f, 0.94f, 0.34f, -1);
  slip.hand(0.71f, 0.72f, -0.94f, 0.34f, 1);
  slip.arrow({{0.36f, 0.42f}, {0.44f, 0.39f}, {0.53f, 0.385f}, {0.62f, 0.42f}});
}

// A bowl of embers hangs by two cords in a jar that is cut open; warmth rises from it.
void draw_fire(Slip& slip) {
  slip.jar();
  slip.both({{0.5f, 0.74f}, {0.44f, 0.73f}, {0.40f, 0.66f}}, view::kInk, 1.8f);
  slip.line({{0.40f, 0.66f}, {0.60f, 0.66f}}, view::kInk, 1.8f);
  slip.both({{0.41f, 0.66f}, {0.47f, 0.14f}}, view::kInk);
  slip.line({{0.43f, 0.63f}, {0.47f, 0.60f}, {0.50f, 0.63f}, {0.54f, 0.60f}, {0.57f, 0.63f}},
            view::kIron, 2.2f);
  for (const float x : {0.44f, 0.50f, 0.56f})
    slip.line({{x, 0.56f}, {x + 0.02f, 0.53f}, {x - 0.02f, 0.48f}, {x, 0.45f}}, view::kIron, 1.4f);
}

}  // namespace

void draw_hands(Page& page, const view::Rect& box, HandsDrawn hands) {
  Slip slip(page, box);
  slip.wheel();
  switch (hands) {
    case HandsDrawn::around:
      draw_lump(slip);
      break;
    case HandsDrawn::inside:
      slip.cylinder();
      slip.hand(0.64f, 0.62f, 0.30f, 0.95f, 1);
      slip.arrow({{0.74f, 0.62f}, {0.90f, 0.62f}});
      break;
    case HandsDrawn::up:
      slip.cylinder();
      slip.hand(0.63f, 0.66f, 0.25f, 0.97f, 1);
      slip.hand(0.70f, 0.70f, -0.91f, 0.42f, 1);
      slip.arrow({{0.90f, 0.46f}, {0.90f, 0.16f}});
      break;
    case HandsDrawn::along:
      slip.jar();
      slip.hand(0.70f, 0.60f, 0.35f, 0.94f, 1);
      slip.hand(0.77f, 0.66f, -0.91f, 0.42f, 1);
      slip.arrow({{0.14f, 0.76f}, {0.12f, 0.64f}, {0.14f, 0.52f}, {0.22f, 0.40f}});
      break;
    case HandsDrawn::rim:
      slip.jar();
      slip.hand(0.61f, 0.40f, 0.10f, 0.99f, 1);
      slip.hand(0.64f, 0.37f, -0.80f, 0.60f, -1);
      break;
    case HandsDrawn::coil:
      slip.rings();
      slip.hand(0.70f, 0.42f, -0.94f, 0.34f, 1);
      slip.arrow({{0.36f, 0.30f}, {0.44f, 0.27f}, {0.53f, 0.265f}, {0.62f, 0.30f}});
      break;
    case HandsDrawn::fire:
      draw_fire(slip);
      break;
    case HandsDrawn::paddle:
      slip.jar();
      slip.line({{0.785f, 0.50f}, {0.785f, 0.72f}}, view::kInk, 3.6f);
      slip.line({{0.80f, 0.50f}, {0.88f, 0.22f}}, view::kInk, 2.0f);
      slip.arrow({{0.96f, 0.62f}, {0.84f, 0.62f}});
      slip.line({{0.685f, 0.56f}, {0.66f, 0.61f}, {0.685f, 0.66f}}, view::kInk, 2.4f);
      break;
    case HandsDrawn::wire:
      slip.jar();
      slip.line({{0.06f, 0.915f}, {0.94f, 0.915f}}, view::kInk, 1.2f);
      slip.line({{0.06f, 0.86f}, {0.06f, 0.97f}}, view::kInk, 2.4f);
      slip.line({{0.94f, 0.86f}, {0.94f, 0.97f}}, view::kInk, 2.4f);
      slip.arrow({{0.74f, 0.82f}, {0.92f, 0.82f}});
      break;
  }
}

void draw_pressing_hand(Page& page, const view::Rect& box, bool inward) {
  if (!inward) return draw_hands(page, box, HandsDrawn::inside);
  Slip slip(page, box);
  slip.wheel();
  slip.cylinder();
  slip.hand(0.69f, 0.62f, -0.91f, 0.42f, 1);
  slip.arrow({{0.62f, 0.62f}, {0.46f, 0.62f}});
}

}  // namespace onggi::screens
