#include "kiosk/picture/render/pacing.h"

#include <algorithm>
#include <cmath>

namespace onggi::render {
namespace {

constexpr int kWarmUp = 3;
constexpr int kSettle = 6;        // frames at a scale before it is judged
constexpr double kStep = 0.0625;  // scales are multiples of it, to need few targets

}  // namespace

void Pacing::frame(double ms) {
  // The first frames compile shaders and set the first texts.
  if (frames_++ < kWarmUp) return;
  // One stall (a new font, a new shader) is not a trend.
  const double counted = mean_ms_ > 0 ? std::min(ms, 3.0 * mean_ms_) : ms;
  mean_ms_ = mean_ms_ > 0 ? mean_ms_ + 0.25 * (counted - mean_ms_) : counted;
  if (++since_change_ < kSettle) return;

  // The cost grows with the picture's area, so aim for the middle of the two limits.
  const double aim = 0.5 * (late_ms_ + idle_ms_);
  double wanted = scale_;
  if (mean_ms_ > late_ms_) wanted = scale_ * std::sqrt(aim / mean_ms_);
  if (mean_ms_ < idle_ms_) wanted = scale_ + kStep;
  if (wanted < scale_) {
    wanted = std::min(std::floor(wanted / kStep) * kStep, scale_ - kStep);
    wanted = std::max(wanted, scale_ - 4 * kStep);
  }
  wanted = std::clamp(wanted, kLeast, kMost);
  if (wanted == scale_) return;
  mean_ms_ *= (wanted * wanted) / (scale_ * scale_);
  scale_ = wanted;
  since_change_ = 0;
}

}  // namespace onggi::render
