#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/device_news.h"
#include "kiosk/wheel/device/device_watch.h"
#include "kiosk/wheel/device/hid_hand.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// The plugged-in hand devices of the kiosk: gives each one a hand of the wheel or the wheel's
/// speed, turns dials and buttons into input, and reports arrivals and removals. Main thread.
class HandDevices {
 public:
  struct Options {
    bool by_hand = false;  ///< The wheel is stepped by hand, and the devices with it.
    bool left_handed = false;
    double force = 1.0;  ///< The exhibit's share, 0 (off) .. 1.
  };
  HandDevices(loop::WheelHost& wheel_host, std::unique_ptr<device::HidBus> bus,
              device::DeviceWatch::Define define, const Options& options);
  ~HandDevices();

  /// Call once a frame; returns the input from dials and buttons.
  std::vector<view::InputEvent> frame(double now);
  /// The visitor's share of the exhibit's force, 0 (off) .. 1, from now on.
  void share(double of_force);
  /// Counts frames in which every device thread ran. It stops when one hangs, so the watchdog
  /// restarts the kiosk.
  std::uint64_t moves() const { return moves_; }
  /// News for visitors.
  const screens::DeviceNews& news() const { return news_; }
  /// Names of the devices in use, for staff.
  std::vector<std::string> plugged_in() const;
  /// Messages for staff, each once.
  std::vector<std::string> remarks();
  std::vector<Problem> problems() { return watch_.problems(); }

 private:
  struct InUse {
    std::shared_ptr<device::HidLink> link;
    device::HidHand* hand = nullptr;  ///< Attached; null for a dial, or if both hands are taken.
    int index = -1;                   ///< Index of that hand.
    std::uint64_t turns = 0;          ///< HidLink::turns(), as of the last moves().
    std::uint32_t buttons = 0;
    double dial = 0.0;
    std::array<std::uint64_t, device::kLinkFaults> faults{};
  };

  void take(std::unique_ptr<device::HidLink> link);
  void let_go(InUse& used);
  void note_faults(InUse& used, const device::LinkStatus& status);
  void add_input(InUse& used, const device::DeviceSample& sample,
                 std::vector<view::InputEvent>& events);
  void buzz_at_a_touch(double now);

  loop::WheelHost& wheel_host_;
  Options options_;
  device::DeviceWatch watch_;
  std::vector<InUse> used_;
  screens::DeviceNews news_;
  std::vector<std::string> remarks_;
  double looked_at_ = -1.0, buzzed_at_ = -1.0, last_frame_ = 0.0;
  double share_ = 1.0;  ///< The visitor's share.
  bool touching_ = false;
  std::uint64_t moves_ = 0;
  std::uint32_t buzzes_ = 0;
};

}  // namespace onggi::exhibit
