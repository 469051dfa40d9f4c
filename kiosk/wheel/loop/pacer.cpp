#include "kiosk/wheel/loop/pacer.h"

#include <algorithm>
#include <cmath>

namespace onggi::loop {

namespace {
constexpr std::int64_t kTickNs = 1'000'000;
constexpr std::int64_t kLateNs = 500'000;
}  // namespace

void Pacer::begin(std::int64_t now_ns) noexcept {
  last_ns_ = woke_ns_ = now_ns;
  wake_at_ = now_ns + kTickNs;
  owed_ = 0;
}

double Pacer::wake(std::int64_t now_ns) noexcept {
  woke_ns_ = now_ns;
  const std::int64_t late = now_ns - wake_at_;
  ++deadlines_.wakes;
  if (late > kLateNs) ++deadlines_.late;
  if (late >= kTickNs) ++deadlines_.overruns;
  in_a_row_ = late >= kTickNs ? in_a_row_ + 1 : 0;
  wake_us_ = static_cast<double>(late) * 1e-3;
  deadlines_.worst_wake_us = std::max(deadlines_.worst_wake_us, wake_us_);

  owed_ += static_cast<double>(now_ns - last_ns_) * 1e-9;
  last_ns_ = now_ns;
  if (owed_ > kForgiven) {
    deadlines_.lost_ticks += static_cast<std::uint64_t>((owed_ - kForgiven) / kTick);
    owed_ = kForgiven;
  }
  // Use whole milliseconds only: wakes jitter by microseconds, and a dt with that jitter would make
  // every tick of a replay different. A slightly early wake still makes a tick; the debt evens out.
  const double whole = std::floor(owed_ / kTick + 1e-9) * kTick;
  const double dt = std::clamp(whole, kTick, kLongest);
  owed_ -= dt;
  return dt;
}

void Pacer::done(std::int64_t now_ns) noexcept {
  tick_us_ = static_cast<double>(now_ns - woke_ns_) * 1e-3;
  deadlines_.worst_tick_us = std::max(deadlines_.worst_tick_us, tick_us_);
  // Skip wakes in the past: their time is already owed or paid.
  wake_at_ += kTickNs;
  if (wake_at_ <= now_ns) wake_at_ += (now_ns - wake_at_ + kTickNs) / kTickNs * kTickNs;
}

}  // namespace onggi::loop
