#include "kiosk/wheel/device/asked_stroke.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace onggi::device {

namespace {

constexpr double kAskStep = 0.002;  // m between the heights of a path
constexpr double kOverFloor = 0.006,
                 kUnderRim = 0.0015;  // m over the floor and under the rim without strokes
constexpr double kAskOut = 0.009, kAskIn = 0.004;          // m of a stroke towards the outline
constexpr double kAskOutMore = 0.003, kAskInMore = 0.002;  // m of a stroke beyond the outline
constexpr double kAtIt = 0.0004;  // m: closer than this the wall counts as at the outline
constexpr double kAskSpeed = 0.025, kEvenSpeed = 0.018;  // m/s
constexpr double kSqueeze = 0.75;  // share of the wall's thickness, when pulled up
// Share of the largest weight below which a stroke does nothing
constexpr double kLeastWeight = 0.02;

constexpr std::array<double, 5> kMiddles{0.08, 0.29, 0.5, 0.71, 0.92};

/// Step in m, positive outwards. `left`: m still missing to the outline in this direction.
double asked_step(Ask ask, double off, double left) {
  const bool on = left <= kAtIt;  // the part is at the outline, so the visitor wants more
  if (ask == Ask::widen) return on ? kAskOutMore : std::clamp(off, 0.0, kAskOut);
  if (ask == Ask::narrow) return on ? -kAskInMore : std::clamp(off, -kAskIn, 0.0);
  return 0;
}

}  // namespace

double middle_of(WallPart part) {
  return part == WallPart::all ? 0.5 : kMiddles[static_cast<std::size_t>(part)];
}

double weight_of(WallPart part, double share) {
  if (part == WallPart::all) return 1;
  const auto n = static_cast<std::size_t>(part);
  const bool below = share < kMiddles[n];
  // The lowest part reaches down to the wheel, the highest up to the rim.
  if (below ? n == 0 : n + 1 == kMiddles.size()) return 1;
  const double next = kMiddles[below ? n - 1 : n + 1];
  const double t = std::clamp((share - kMiddles[n]) / (next - kMiddles[n]), 0.0, 1.0);
  return 1 - t * t * (3 - 2 * t);
}

Stroke asked_stroke(const ClayView& clay, const Profile& target, Ask ask, WallPart part) {
  if (ask == Ask::open || ask == Ask::widen) {
    if (auto thick = opening_stroke(clay, target)) return *thick;
    if (ask == Ask::open) return asked_stroke(clay, target, Ask::widen, WallPart::all);
  }
  Stroke stroke;
  stroke.kind = ask == Ask::widen    ? Stroke::Kind::belly
                : ask == Ask::narrow ? Stroke::Kind::collar
                                     : Stroke::Kind::smooth;
  stroke.speed = ask == Ask::widen || ask == Ask::narrow ? kAskSpeed : kEvenSpeed;
  if (ask == Ask::pull) stroke.squeeze = kSqueeze;
  struct At {
    double height, now, off, weight;
  };
  std::vector<At> all;
  double left = 0;
  const double rim = clay.rim_height();
  for (double h = clay.floor_top() + kOverFloor; h <= rim - kUnderRim; h += kAskStep) {
    const double weight = weight_of(part, h / rim);
    if (weight < kLeastWeight) continue;
    const double now = clay.radius_at(h, WallSide::outside);
    const double off = wanted_radius(clay, target, h) - now;
    all.push_back({h, now, off, weight});
    left = std::max(left, weight * (ask == Ask::narrow ? -off : off));
  }
  for (const At& at : all)
    stroke.path.push_back({at.now + at.weight * asked_step(ask, at.off, left), at.height});
  return stroke;
}

}  // namespace onggi::device
