#include "tests/stand_in/simulated_others.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kiosk/ground/files/crc32.h"
#include "kiosk/wheel/device/device_def.h"

namespace onggi::stand_in {

using device::put_i16;
using device::put_u32;

device::HidListing SimulatedDial::listing() const {
  return {"", 0x045e, 0x091b, 1, 0x0e, true, "Surface Dial (simulated)", "1"};
}

std::optional<Bytes> SimulatedDial::tick() {
  ++ms_;
  const long turning = std::clamp(ms_ - from_, 0L, 1000L);
  const bool pressed = std::any_of(clicks_.begin(), clicks_.end(),
                                   [this](long at) { return ms_ >= at && ms_ < at + 100; });
  const long counts = ms_ % 10 == 0 ? tenths_ * turning / 1000 * counts_ / 3600 : told_;
  if (counts == told_ && pressed == pressed_) return std::nullopt;
  // Button and touch, the turn, no place on a screen, and 58 mm across.
  Bytes report{1, static_cast<std::uint8_t>(pressed ? 3 : 0), 0, 0, 0, 0, 0, 0, 58};
  put_i16(report, 2, static_cast<std::int16_t>(counts - std::exchange(told_, counts)));
  pressed_ = pressed;
  return report;
}

std::optional<Bytes> SimulatedDial::feature(std::uint8_t id) {
  if (id != 1) return std::nullopt;
  return Bytes{1,
               static_cast<std::uint8_t>(counts_ & 0xff),
               static_cast<std::uint8_t>(counts_ >> 8),
               0,
               2,
               0,
               0,
               0};
}

bool SimulatedDial::take(const Bytes& report) {
  if (report.size() != 5 || report[0] != 1 || report[2] != 3) return false;
  buzzes_ += report[1];
  return true;
}

device::HidListing SimulatedController::listing() const {
  return {"", 0x054c, 0x0ce6, 1, 5, bluetooth_, "DualSense (simulated)", "1"};
}

std::optional<Bytes> SimulatedController::tick() {
  ++ms_;
  if (ms_ % 4 != 0) return std::nullopt;
  if (bluetooth_ && !full_) return Bytes{1, 128, 128, 128, 128, 8, 0, 0, 0, 0};
  Bytes report(bluetooth_ ? 78 : 64, 0);
  const std::size_t at = bluetooth_ ? 2 : 1;
  report[0] = bluetooth_ ? 0x31 : 0x01;
  const int sticks[] = {x_, y_, 128, 128};
  for (std::size_t n = 0; n < 4; ++n) report[at + n] = static_cast<std::uint8_t>(sticks[n]);
  report[at + 6] = sequence_++;
  report[at + 7] = 8;
  put_i16(report, at + 15, static_cast<std::int16_t>(ms_ > from_ && ms_ <= to_ ? tilt_ : 0));
  if (bluetooth_) {
    Bytes all{0xA1};
    all.insert(all.end(), report.begin(), report.end() - 4);
    put_u32(report, 74, files::crc32(all));
  }
  return report;
}

bool SimulatedController::take(const Bytes& report) {
  if (report.size() != (bluetooth_ ? 78u : 63u)) return false;
  const std::size_t at = bluetooth_ ? 3 : 1;
  if (report[0] != (bluetooth_ ? 0x31 : 0x02) || report[at] != 3) return false;
  if (bluetooth_) {
    Bytes all{0xA2};
    all.insert(all.end(), report.begin(), report.end() - 4);
    if (device::u32_at(report, 74) != files::crc32(all)) return false;
  }
  quick_ = report[at + 2];
  slow_ = report[at + 3];
  return true;
}

std::optional<Bytes> SimulatedController::feature(std::uint8_t id) {
  if (id != 5) return std::nullopt;
  full_ = true;
  Bytes calibration(41, 0);
  calibration[0] = 5;
  return calibration;
}

device::HidListing SimulatedArm::listing() const {
  return {"", 0x16c0, 0x0486, 0xffab, 0x0200, false, "WoodenHaptics (simulated)", "1"};
}

std::optional<Bytes> SimulatedArm::tick() {
  ++ms_;
  if (!spoken_to_) return std::nullopt;
  if (ms_ - told_ms_ > 500) current_ = {};
  const device::DeviceDef def = device::default_def(device::DeviceKind::polhem);
  const Vec3 studio = track_.empty() ? Vec3{} : track_.at(ms_).at - def.home;
  const Vec3 goal = device::to_device(def, studio);
  // Newton's way to the counts that put the handle there, from the last ones.
  std::array<double, 3> angles = device::arm_angles(
      arm_, {static_cast<std::int16_t>(counts_[0]), static_cast<std::int16_t>(counts_[1]),
             static_cast<std::int16_t>(counts_[2])});
  if (counts_ == std::array<int, 3>{}) angles = {0.0, 0.1, 1.4};
  for (int n = 0; n < 30; ++n) {
    const Vec3 miss = goal - device::arm_position(arm_, angles);
    if (length(miss) < 1e-9) break;
    constexpr double kStep = 1e-5;
    std::array<Vec3, 3> column;
    for (std::size_t k = 0; k < 3; ++k) {
      auto moved = angles;
      moved[k] += kStep;
      column[k] =
          (1.0 / kStep) * (device::arm_position(arm_, moved) - device::arm_position(arm_, angles));
    }
    const double det = dot(column[0], cross(column[1], column[2]));
    if (std::fabs(det) < 1e-9) break;
    const std::array<double, 3> by{dot(miss, cross(column[1], column[2])) / det,
                                   dot(miss, cross(column[2], column[0])) / det,
                                   dot(miss, cross(column[0], column[1])) / det};
    for (std::size_t k = 0; k < 3; ++k) angles[k] += std::clamp(by[k], -0.2, 0.2);
  }
  Bytes report(64, 0);
  for (std::size_t k = 0; k < 3; ++k) {
    const double turns = angles[k] * arm_.body[k] / arm_.capstan[k] / (2.0 * 3.14159265358979);
    counts_[k] = static_cast<int>(std::lround(turns * arm_.counts[k]));
    put_i16(report, 2 * k, static_cast<std::int16_t>(counts_[k]));
  }
  return report;
}

bool SimulatedArm::take(const Bytes& report) {
  if (report.size() != 65 || report[0] != 0) return false;
  spoken_to_ = true;
  told_ms_ = ms_;
  if (device::i16_at(report, 7) == 0)
    for (std::size_t k = 0; k < 3; ++k) current_[k] = device::i16_at(report, 1 + 2 * k);
  return true;
}

}  // namespace onggi::stand_in
