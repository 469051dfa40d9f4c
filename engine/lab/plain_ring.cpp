#include "engine/lab/plain_ring.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab {
namespace {

constexpr double kRoundRing = 2.0 * portable::kPi;
constexpr double kKept = 0.8;  // of the coil's radius: its top and bottom tenth are pressed flat
constexpr int kPathPlaces = 20'000;

}  // namespace

PlainRing::PlainRing(double coil, const std::function<Hands(double)>& hands, double seconds)
    : coil_(coil) {
  double before = 0.0, turns = 0.0;
  for (int n = 0; n <= kPathPlaces; ++n) {
    const HandInput hand = hands(seconds * n / kPathPlaces).hand[0];
    if (!hand.active || !hand.coil) break;
    const double angle = portable::atan2(hand.position.z, hand.position.x);
    if (angle - before < -portable::kPi) turns += kRoundRing;
    before = angle;
    angles_.push_back(angle + turns);
    centres_.push_back(length(Vec2{hand.position.x, hand.position.z}));
  }
  // The gap is as wide as its arc at the end nearer to the axis.
  gap_ = kRoundRing;
  for (std::size_t n = 0; n < angles_.size() && gap_ == kRoundRing; ++n)
    if ((kRoundRing - angles_[n]) * std::min(centres_[n], centres_.front()) < coil_)
      gap_ = angles_[n];
}

double PlainRing::on_path(double angle) const {
  const auto after = std::ranges::upper_bound(angles_, angle);
  const auto n = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - angles_.begin(), 1, std::ssize(angles_) - 1));
  const double way = angles_[n] - angles_[n - 1];
  const double share = way > 0.0 ? (angle - angles_[n - 1]) / way : 0.0;
  return centres_[n - 1] + std::clamp(share, 0.0, 1.0) * (centres_[n] - centres_[n - 1]);
}

double PlainRing::centre(double angle) const {
  if (angle <= gap_) return on_path(angle);
  const double end = on_path(gap_);
  return end + (angle - gap_) / (kRoundRing - gap_) * (centres_.front() - end);
}

// The mean of sqrt(1 - y^2) over -kKept..kKept, in coils.
double PlainRing::height() const {
  const double mean = 0.5 * (std::sqrt(1.0 - kKept * kKept) + portable::asin(kKept) / kKept);
  return 0.25 * portable::kPi * coil_ / mean;
}

double PlainRing::width(double up) const {
  const double y = kKept * (2.0 * up / height() - 1.0);
  return coil_ * std::sqrt(std::max(1.0 - y * y, 0.0));
}

double PlainRing::volume() const {
  double sum = 0.0;
  for (int n = 0; n < kPathPlaces; ++n) sum += centre((n + 0.5) * kRoundRing / kPathPlaces);
  return 0.25 * portable::kPi * coil_ * coil_ * sum * kRoundRing / kPathPlaces;
}

FaceGrid PlainRing::face(WallSide side, double rim, double low, double high, int heights,
                         int sectors) const {
  FaceGrid face{heights, sectors, rim + low, (high - low) / (heights - 1), 0.0, {}};
  const double way = side == WallSide::outside ? 0.5 : -0.5;
  for (int j = 0; j < heights; ++j) {
    const double wide = way * width(low + j * face.thickness);
    for (int i = 0; i < sectors; ++i)
      face.radius.push_back(centre((i + 0.5) * kRoundRing / sectors) + wide);
  }
  return face;
}

}  // namespace onggi::lab
