#include "engine/lab/handle.h"

#include <algorithm>
#include <cmath>

#include "engine/math/portable.h"

namespace onggi::lab {

namespace {

double whole(double value, double step) { return std::floor(value / step + 0.5) * step; }

}  // namespace

Handle::Handle(const DeviceModel& device, const HandModel& hand, Vec3 at, double seconds)
    : device_(device), hand_(hand), part_(seconds / kParts), at_(at) {
  device_.delay = std::clamp(device_.delay, 0, DeviceModel::kMostDelay);
  decay_ = portable::exp(-(device_.damping + hand_.damping) * part_ / (device_.mass + hand_.mass));
}

Vec3 Handle::told() const {
  const double step = device_.step;
  if (!(step > 0.0)) return at_;
  return {whole(at_.x, step), whole(at_.y, step), whole(at_.z, step)};
}

Vec3 Handle::held(Vec3 force) {
  newest_ = (newest_ + 1) % wire_.size();
  wire_[newest_] = force;
  return wire_[(newest_ + wire_.size() - static_cast<std::size_t>(device_.delay)) % wire_.size()];
}

void Handle::go(Vec3 force, Vec3 push, Vec3 rest) {
  const Vec3 device_force = held(force);
  const double mass = device_.mass + hand_.mass;
  const double damping = device_.damping + hand_.damping;
  // Exact for a constant force with damping: x' goes to F / B exponentially.
  const double gain = damping > 0.0 ? (1.0 - decay_) / damping : part_ / mass;
  const double rub = device_.friction * part_ / mass;
  for (int n = 0; n < kParts; ++n) {
    const Vec3 before = at_;
    at_ += 0.5 * part_ * speed_;
    const Vec3 all = device_force + push + hand_.stiffness * (rest - at_);
    speed_ = decay_ * speed_ + gain * all;
    const double fast = length(speed_);
    speed_ = fast > rub ? (1.0 - rub / fast) * speed_ : Vec3{};
    at_ += 0.5 * part_ * speed_;
    const Vec3 way = at_ - before;
    work_ += dot(device_force, way);
    lost_ += (device_.damping * dot(way, way) / part_) + device_.friction * length(way);
  }
}

void Handle::lead(Vec3 force, Vec3 to) {
  const Vec3 device_force = held(force);
  const Vec3 way = to - at_;
  const double seconds = part_ * kParts;
  speed_ = (1.0 / seconds) * way;
  work_ += dot(device_force, way);
  lost_ += device_.damping * dot(way, way) / seconds + device_.friction * length(way);
  at_ = to;
}

}  // namespace onggi::lab
