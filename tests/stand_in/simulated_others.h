#pragma once

#include <array>
#include <utility>
#include <vector>

#include "kiosk/wheel/device/arm_kinematics.h"
#include "tests/stand_in/simulated_device.h"
#include "tests/stand_in/track.h"

namespace onggi::stand_in {

/// A Surface Dial that somebody turns for a second, and clicks.
class SimulatedDial final : public SimulatedDevice {
 public:
  /// Turned by `tenths` of a degree in the second from `from` ms on; each of `clicks` is a press,
  /// at that ms, of a tenth of a second. It counts `counts` to a turn.
  explicit SimulatedDial(int tenths, long from = 1000, std::vector<long> clicks = {},
                         int counts = 3600)
      : tenths_(tenths), from_(from), clicks_(std::move(clicks)), counts_(counts) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  std::optional<Bytes> feature(std::uint8_t id) override;
  int buzzes() const { return buzzes_; }

 private:
  int tenths_;
  long from_;
  std::vector<long> clicks_;
  int counts_;
  long ms_ = 0, told_ = 0;  ///< told_: counts so far.
  bool pressed_ = false;
  int buzzes_ = 0;
};

/// A DualSense at rest, or with its left stick held over, or tilted for `seconds` from `from` ms
/// on, at `tilt` of its gyroscope's counts about its first axis; by cable or by radio.
class SimulatedController final : public SimulatedDevice {
 public:
  SimulatedController(bool bluetooth, int stick_x, int stick_y, int tilt = 0, long from = 0,
                      double seconds = 1.0)
      : bluetooth_(bluetooth),
        x_(stick_x),
        y_(stick_y),
        tilt_(tilt),
        from_(from),
        to_(from + static_cast<long>(1e3 * seconds)) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  std::optional<Bytes> feature(std::uint8_t id) override;
  int slow() const { return slow_; }
  int quick() const { return quick_; }

 private:
  bool bluetooth_;
  int x_, y_, tilt_;
  long from_, to_;
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
