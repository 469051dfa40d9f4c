#include "kiosk/wheel/device/report_interpolation.h"

#include <algorithm>

namespace onggi::device {

Vec3 ReportInterpolation::at(Vec3 place, std::uint64_t reports, std::int64_t at_ns,
                             std::int64_t now_ns, double dt, double smoothing) noexcept {
  if (reports_ == 0) out_ = last_ = place;
  if (reports != reports_) {
    apart_ = static_cast<double>(at_ns - last_ns_) * 1e-9;
    const bool joined = reports_ > 0 && apart_ > 0.0 && apart_ <= kLongest;
    speed_ = joined ? (1.0 / apart_) * (place - last_) : Vec3{};
    last_ = place;
    last_ns_ = at_ns;
    reports_ = reports;
  }
  const double since = static_cast<double>(now_ns - last_ns_) * 1e-9;
  const double ahead = std::clamp(since, 0.0, apart_);
  const Vec3 guess = last_ + ahead * speed_;
  if (since < apart_) out_ += dt * speed_;
  out_ += (dt / (smoothing + dt)) * (guess - out_);
  return out_;
}

}  // namespace onggi::device
