#include "kiosk/visit/screens/drift.h"

#include <algorithm>
#include <cmath>

namespace onggi::screens {

namespace {

constexpr double kPixelEvery = 150.0;  // s
constexpr float kFarthest = 12.0f;     // pixels
// The golden ratio, so that the path over the square does not soon repeat.
constexpr double kSlower = 1.618;

/// 0, 1 .. most .. 0 .. -most .. 0, and so on.
int to_and_fro(double steps, int most) {
  if (most == 0) return 0;
  const int at = static_cast<int>(std::fmod(std::floor(steps), 4.0 * most));
  if (at <= most) return at;
  return at <= 3 * most ? 2 * most - at : at - 4 * most;
}

}  // namespace

Drift drift(double seconds, float margin) {
  const int most = static_cast<int>(std::min(kFarthest, std::max(0.0f, 0.25f * margin)));
  const double steps = std::max(0.0, seconds) / kPixelEvery;
  return {to_and_fro(steps, most), to_and_fro(steps / kSlower, most)};
}

Regions moved(Regions regions, Drift by) {
  for (view::Rect* rect : {&regions.words, &regions.pot, &regions.page}) {
    rect->x += static_cast<float>(by.x);
    rect->y += static_cast<float>(by.y);
  }
  return regions;
}

}  // namespace onggi::screens
