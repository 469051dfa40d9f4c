#include "tests/stand_in/simulated_handle.h"

#include <cmath>

namespace onggi::stand_in {

namespace {
// A handle of 150 g and a hand that holds on firmly: Hajian and Howe 1997 measured fingers at 200
// to 1500 N/m; a hand that guides a tool by eye is at the upper end.
constexpr double kMass = 0.15, kStiffness = 1500.0, kDamping = 30.0;
constexpr int kSteps = 4;
}  // namespace

SimulatedHandle::SimulatedHandle(Track track, std::uint16_t max_force_mn)
    : track_(std::move(track)),
      build_{max_force_mn, 20, {-1000, -1000, -1000}, {1000, 1000, 1000}, 1, 0x0100, 1} {
  onggi_hid_start(&device_, &build_);
}

device::HidListing SimulatedHandle::listing() const {
  return {"", 0x16c0, 0x27d9, 0xff00, 1, false, "onggi-hid reference (simulated)", "1"};
}

Vec3 SimulatedHandle::force() const {
  std::int32_t f[3];
  onggi_hid_force(&device_, f);
  return {f[0] * 1e-3, f[1] * 1e-3, f[2] * 1e-3};
}

std::optional<Bytes> SimulatedHandle::tick() {
  ++ms_;
  const TrackPoint wish = track_.at(ms_);
  const Vec3 goal = track_.empty() ? Vec3{} : wish.at - home_;
  for (int n = 0; n < kSteps; ++n) {
    constexpr double kDt = 1e-3 / kSteps;
    const Vec3 hand = kStiffness * (goal - place_) - kDamping * speed_;
    speed_ += (kDt / kMass) * (hand + force());
    place_ += kDt * speed_;
  }
  if (!wish.active && !track_.empty()) {
    place_ = goal;  // Lifted away from the sensor, it may be carried anywhere.
    speed_ = {};
  }
  const std::int32_t at[3] = {static_cast<std::int32_t>(std::lround(place_.x * 1e7)),
                              static_cast<std::int32_t>(std::lround(place_.y * 1e7)),
                              static_cast<std::int32_t>(std::lround(place_.z * 1e7))};
  onggi_hid_tick(&device_, 1000, at, wish.active, 1, buttons);
  Bytes out(ONGGI_HID_INPUT_SIZE);
  onggi_hid_input(&device_, out.data());
  return out;
}

bool SimulatedHandle::take(const Bytes& report) {
  onggi_hid_take(&device_, report.data(), report.size());
  return true;  // The wire took it, whatever the device thinks of it.
}

std::optional<Bytes> SimulatedHandle::feature(std::uint8_t id) {
  if (id != 3) return std::nullopt;
  Bytes out(ONGGI_HID_FEATURE_SIZE);
  onggi_hid_feature(&device_, out.data());
  return out;
}

void SimulatedHandle::plug(bool in) {
  if (in)
    onggi_hid_resume(&device_);
  else
    onggi_hid_suspend(&device_);
}

}  // namespace onggi::stand_in
