#pragma once

#include <array>

#include "kiosk/wheel/device/device_def.h"
#include "kiosk/wheel/device/reference/onggi_hid_device.h"
#include "tests/stand_in/simulated_device.h"
#include "tests/stand_in/track.h"

namespace onggi::stand_in {

/// The reference device of kiosk/wheel/device/reference, as built: a handle with a mass, pushed by
/// the device's force on one side and by a visitor's hand on the other, which holds to a track as
/// muscles do: a spring and a damper to where it wants to be.
class SimulatedHandle final : public SimulatedDevice {
 public:
  explicit SimulatedHandle(Track track, std::uint16_t max_force_mn = 5000);
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  std::optional<Bytes> feature(std::uint8_t id) override;
  void plug(bool in) override;

  /// What the motors push with now, N.
  Vec3 force() const;
  Vec3 place() const { return place_; }

  std::uint16_t buttons = 0;  ///< Held down; the lowest is the clutch.

 private:
  Track track_;
  onggi_hid_build build_;
  onggi_hid_device device_{};
  Vec3 home_ = device::default_def(device::DeviceKind::onggi_hid).home;
  Vec3 place_, speed_;
  long ms_ = 0;
};

}  // namespace onggi::stand_in
