#include "kiosk/wheel/device/force_gate.h"

#include <algorithm>
#include <cmath>

namespace onggi::device {

namespace {
constexpr double kLongestStep = 0.005;  // s: the force does not jump after a pause
constexpr double kShortestStep = 1e-6;
}  // namespace

Vec3 ForceGate::step(Vec3 wanted, double seconds, const ForceLimits& limits,
                     LinkFault& fault) noexcept {
  if (fault == LinkFault::none && !is_finite(wanted)) fault = LinkFault::not_a_number;
  if (fault != LinkFault::none) {
    cut();
    return {};
  }
  const double dt =
      std::clamp(std::isfinite(seconds) ? seconds : kShortestStep, kShortestStep, kLongestStep);
  bool finite = true;
  return guard_.step(wanted, dt, {limits.cap, limits.slew, limits.engage_time}, finite);
}

Vec3 whole_millinewtons(Vec3 force) noexcept {
  const auto whole = [](double value) { return std::trunc(value * 1e3) * 1e-3; };
  return {whole(force.x), whole(force.y), whole(force.z)};
}

}  // namespace onggi::device
