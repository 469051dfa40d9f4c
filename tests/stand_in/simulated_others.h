#pragma once

#include <array>

#include "kiosk/device/arm_kinematics.h"
#include "tests/stand_in/simulated_device.h"
#include "tests/stand_in/track.h"

namespace onggi::stand_in {

/// A Surface Dial that somebody turns for a second from time to time, and clicks.
class SimulatedDial final : public SimulatedDevice {
 public:
  /// Tenths of a degree in each turned second; nothing for 0.
  explicit SimulatedDial(int tenths) : tenths_(tenths) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  int buzzes() const { return buzzes_; }

 private:
  int tenths_;
  long ms_ = 0;
  int buzzes_ = 0;
};

/// A DualSense at rest, or with its left stick held over; by cable or by radio.
class SimulatedController final : public SimulatedDevice {
 public:
  SimulatedController(bool bluetooth, int stick_x, int stick_y)
      : bluetooth_(bluetooth), x_(stick_x), y_(stick_y) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  std::optional<Bytes> feature(std::uint8_t id) override;
  int slow() const { return slow_; }
  int quick() const { return quick_; }

 private:
  bool bluetooth_;
  int x_, y_;
  bool full_ = false;  ///< By radio: somebody asked for the calibration.
  std::uint8_t sequence_ = 0;
  long ms_ = 0;
  int slow_ = 0, quick_ = 0;
};

/// WoodenHaptics, as its maker describes it: counts out, currents in, made a force by the arm's own
/// torque. The handle stands where a track says. After half a second without a word the motors are
/// off.
class SimulatedArm final : public SimulatedDevice {
 public:
  explicit SimulatedArm(Track track) : track_(std::move(track)) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  const std::array<int, 3>& milliamperes() const { return current_; }

 private:
  device::ArmDef arm_;
  Track track_;
  std::array<int, 3> current_{}, counts_{};
  bool spoken_to_ = false;
  long ms_ = 0, told_ms_ = 0;
};

}  // namespace onggi::stand_in
