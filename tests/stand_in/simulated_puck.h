#pragma once

#include "kiosk/wheel/device/device_def.h"
#include "tests/stand_in/simulated_device.h"
#include "tests/stand_in/track.h"

namespace onggi::stand_in {

/// A SpaceMouse with a hand on it that leads the tool along a track: it pushes the puck as fast as
/// the tool has to go, and carries it round the outside from one stroke to the next.
class SimulatedPuck final : public SimulatedDevice {
 public:
  enum class Reports : std::uint8_t { split, combined };
  SimulatedPuck(Reports reports, Track track) : reports_(reports), track_(std::move(track)) {}
  device::HidListing listing() const override;
  std::optional<Bytes> tick() override;
  bool take(const Bytes& report) override;
  bool lit() const { return lit_; }

 private:
  Vec3 goal() const;
  void push();

  Reports reports_;
  Track track_;
  device::DeviceDef def_ = device::default_def(device::DeviceKind::space_mouse);
  long ms_ = 0;
  bool second_half_ = false, lit_ = false, told_rest_ = true;
  long rested_ = 100000;  ///< ms since it last pushed.
  Vec3 tool_;             ///< As the hand believes.
  Vec3 speed_;            ///< That it asked for, m/s.
  std::array<int, 3> counts_{};
};

}  // namespace onggi::stand_in
