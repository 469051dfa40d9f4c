#include "kiosk/visit/screens/pointing_hand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace onggi::screens {

namespace {

using Point = std::pair<float, float>;

// The outline in finger's widths, y down: index, three curled fingers, the hand's edge, the wrist,
// the thumb.
constexpr std::array<Point, 39> kHand{
    {{-0.5f, 0.55f},  {-0.36f, 0.14f}, {0.0f, 0.0f},   {0.36f, 0.14f},  {0.5f, 0.55f},
     {0.54f, 1.6f},   {0.58f, 2.5f},   {0.72f, 2.25f}, {0.98f, 2.14f},  {1.28f, 2.28f},
     {1.4f, 2.72f},   {1.54f, 2.48f},  {1.8f, 2.38f},  {2.08f, 2.52f},  {2.2f, 2.98f},
     {2.32f, 2.82f},  {2.56f, 2.8f},   {2.78f, 3.02f}, {2.86f, 3.5f},   {2.84f, 4.2f},
     {2.7f, 5.0f},    {2.46f, 5.8f},   {2.34f, 6.4f},  {2.3f, 7.2f},    {1.3f, 7.2f},
     {0.3f, 7.2f},    {0.24f, 6.5f},   {-0.06f, 5.9f}, {-0.55f, 5.35f}, {-1.0f, 4.75f},
     {-1.34f, 4.1f},  {-1.5f, 3.68f},  {-1.42f, 3.4f}, {-1.16f, 3.36f}, {-0.88f, 3.66f},
     {-0.62f, 3.98f}, {-0.52f, 3.8f},  {-0.52f, 2.6f}, {-0.5f, 1.5f}}};
constexpr float kLean = 0.3f;       // rad
constexpr float kWrist = 7.2f;      // finger's widths from the tip,
constexpr float kFadesFrom = 0.5f;  // and the share from which the hand fades
constexpr float kSkin = 0.5f, kEdge = 0.75f;
constexpr int kHandStrip = 2;  // pixels

/// 1 .. 0 towards the wrist; `down`: finger's widths from the tip.
float whole(float down) {
  return std::clamp((1.0f - down / kWrist) / (1.0f - kFadesFrom), 0.0f, 1.0f);
}

}  // namespace

void draw_pointing_hand(Page& page, std::pair<float, float> tip, float finger, float shown) {
  const float side = page.where().mirrored ? -1.0f : 1.0f;
  const float c = std::cos(kLean), s = std::sin(kLean);
  std::vector<Point> outline;
  std::vector<view::Color> colors;
  for (const auto& [x, y] : kHand) {
    outline.emplace_back(tip.first + side * finger * (c * x + s * y),
                         tip.second + finger * (c * y - s * x));
    colors.push_back(view::with_alpha(view::kInk, kEdge * shown * whole(y)));
  }
  outline.push_back(outline.front());
  colors.push_back(colors.front());
  // The area in strips of whole pixels, so that none covers another.
  const auto [low, high] =
      std::ranges::minmax(outline, {}, [](const Point& p) { return p.second; });
  for (int y = static_cast<int>(low.second); y < static_cast<int>(high.second); y += kHandStrip) {
    const float middle = static_cast<float>(y) + 0.5f * kHandStrip;
    std::vector<float> cuts;
    for (std::size_t n = 0; n + 1 < outline.size(); ++n) {
      const auto &a = outline[n], &b = outline[n + 1];
      if ((a.second <= middle) == (b.second <= middle)) continue;
      cuts.push_back(a.first + (b.first - a.first) * (middle - a.second) / (b.second - a.second));
    }
    std::ranges::sort(cuts);
    const float down = (middle - tip.second) / finger;
    const view::Color skin = view::with_alpha(view::kPlaster, kSkin * shown * whole(down));
    for (std::size_t n = 0; n + 1 < cuts.size(); n += 2)
      page.draw(view::Box{
          {cuts[n], static_cast<float>(y), cuts[n + 1] - cuts[n], kHandStrip}, 0, skin, 0, {}});
  }
  page.draw(view::Line{std::move(outline), std::move(colors),
                       std::max(2.0f, page.type().hairline * 2.0f)});
}

}  // namespace onggi::screens
