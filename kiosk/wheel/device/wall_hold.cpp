#include "kiosk/wheel/device/wall_hold.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kPassing = 1.1;     // of its radius: the width that a hand needs in a mouth
constexpr double kBelowRim = 0.002;  // m: hands that hold a wall stay this far below its rim
constexpr double kFloat = 0.3;    // of its radius: height of a ball's middle above wheel or floor
constexpr double kSpare = 0.001;  // m of space around a finger inside
// m between two hands: smallest and largest gap that they can hold.
constexpr double kLeastGap = 0.003, kMostGap = 0.06;
// m up and down over which the wall's slant is measured, so that a groove does not count as slant.
constexpr double kSpan = 0.01;
// m up and down over which its thickness is measured. Rising hands change the thickness at their
// own height, and measuring only there would make them swing.
constexpr double kThickSpan = 0.012;
constexpr double kSteepest = 2.5;  // run over rise: flatter walls have no inside and outside

double mean_radius(const ClayView& clay, double height) {
  return 0.5 *
         (clay.radius_at(height, WallSide::outside) + clay.radius_at(height, WallSide::inside));
}

/// The slant at which a ball of `radius` that touches squarely is `room` off the level.
double slant_within(double room, double radius) {
  const double sine = std::clamp(room / radius, 0.0, 0.99);
  return sine / std::sqrt(1 - sine * sine);
}
}  // namespace

/// Both faces around `height`, means over kThickSpan up and down.
WallHold::Faces WallHold::seen(const ClayView& clay, double height) {
  constexpr int kLooks = 4;  // to each side
  Faces mean;
  for (int n = -kLooks; n <= kLooks; ++n) {
    const double at = std::clamp(height + n * kThickSpan / kLooks, clay.floor_top() + kSpare,
                                 std::max(clay.floor_top() + kSpare, clay.rim_height()));
    mean.outer += clay.radius_at(at, WallSide::outside) / (2 * kLooks + 1);
    mean.inner += clay.radius_at(at, WallSide::inside) / (2 * kLooks + 1);
  }
  return mean;
}

double WallHold::thickness(const ClayView& clay, double height) {
  const Faces faces = seen(clay, height);
  return faces.outer - faces.inner;
}

void WallHold::take(const ClayView& clay, Grip grip, double height) {
  grip_ = grip;
  double narrowest = clay.radius_at(height, WallSide::inside);
  for (int j = 0; j < clay.rows(); ++j)
    if (clay.row_height(j) > height) narrowest = std::min(narrowest, clay.mean_inner(j));
  inner_ = narrowest > kPassing * broad_.radius ? broad_ : fine_;
}

double WallHold::lowest(const ClayView& clay) const {
  return grip_ == Grip::inside          ? clay.floor_top() + kFloat * inner_.radius
         : broad_.below > broad_.radius ? broad_.below + kSpare
                                        : kFloat * broad_.radius;
}

double WallHold::highest(const ClayView& clay) const {
  const double over = grip_ == Grip::both      ? -kBelowRim
                      : grip_ == Grip::outside ? broad_.radius
                                               : inner_.radius;
  return std::max(lowest(clay), clay.rim_height() + over);
}

double WallHold::face(const ClayView& clay, double height) const {
  return clay.radius_at(height, grip_ == Grip::inside ? WallSide::inside : WallSide::outside);
}

/// Slope of the wall (run over rise) around `height`. Near the rim it is limited so that the hands
/// do not lie down on it; at a foot that widens downwards, so that the inner hand stays off the
/// floor.
double WallHold::slope(const ClayView& clay, double height) const {
  const double low = std::max(clay.floor_top(), height - kSpan);
  const double high = std::min(clay.rim_height() - kSpare, height + kSpan);
  if (high - low < 0.5 * kSpan) return 0;
  const double slant = (mean_radius(clay, high) - mean_radius(clay, low)) / (high - low);
  const double above = slant_within(clay.rim_height() - height, broad_.radius);
  const double below = slant_within(height - clay.floor_top(), broad_.radius);
  return std::clamp(slant, -std::min({kSteepest, above, below}), std::min(kSteepest, above));
}

bool WallHold::solid(const ClayView& clay, double height) const {
  return grip_ != Grip::inside && height < clay.floor_top();
}

WallHold::Hands WallHold::stand(const ClayView& clay, double reach, double height,
                                double wall) const {
  const Faces faces = seen(clay, height);
  const double thick = faces.outer - faces.inner;
  // If both hands went inwards, a thick wall would close its bore, because rings keep their clay.
  const double collared =
      std::max(std::min(thick, kThick), thick - std::max(0.0, faces.outer - reach));
  const double asked = wall > 0 ? std::min(thick, std::max(wall, thick - kBite)) : collared;
  const double finger = fine_.radius + kSpare, least = kLeastGap + finger;
  const double gap =
      std::clamp(std::min(asked, std::max(reach, least) - finger), kLeastGap, kMostGap);
  const double slant = slope(clay, height), cosine = 1 / std::sqrt(1 + slant * slant);
  const auto at = [&](const Part& part, double face, double away) {
    return Stand{true, std::max(0.0, face + away * cosine), height - away * cosine * slant, part};
  };
  Hands hands;
  if (grip_ == Grip::inside) {
    hands.inside = at(inner_, reach, -inner_.radius);
    return hands;
  }
  hands.outside = at(broad_, reach, broad_.radius);
  if (grip_ == Grip::outside || solid(clay, height)) return hands;
  hands.outside.radius = std::max(hands.outside.radius, least + broad_.radius);
  const Stand inside = at(inner_, reach - gap, -inner_.radius);
  if (inside.height > clay.floor_top() + kFloat * inner_.radius) hands.inside = inside;
  return hands;
}

}  // namespace onggi::device
