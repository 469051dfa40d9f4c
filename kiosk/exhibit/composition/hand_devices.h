#pragma once

#include <memory>
#include <string>
#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/device_news.h"
#include "kiosk/wheel/device/device_watch.h"
#include "kiosk/wheel/device/hid_hand.h"
#include "kiosk/wheel/loop/potter_host.h"

namespace onggi::exhibit {

/// The hand devices of the kiosk while they are plugged in: gives each a hand of the wheel, or the
/// wheel, turns dials and buttons into input, and tells what came and went. Main thread.
class HandDevices {
 public:
  struct Options {
    bool by_hand = false;  ///< The wheel is turned by hand, and devices with it.
    bool left_handed = false;
    double force = 1.0;  ///< The exhibit's share, 0 (off) .. 1.
  };
  HandDevices(loop::PotterHost& potter, std::unique_ptr<device::HidBus> bus,
              device::DeviceWatch::Define define, const Options& options);
  ~HandDevices();

  /// Once a frame: what dials and buttons did.
  std::vector<view::InputEvent> frame(double now);
  /// The visitor's share of the exhibit's force, 0 (off) .. 1, from now on.
  void share(double of_force);
  /// Goes up, at most by one a frame, when each device in use has had a turn since it last did: one
  /// that hangs holds it, and then the kiosk cannot let go of that device either.
  std::uint64_t moves() const { return moves_; }
  /// What visitors are told.
  const screens::DeviceNews& news() const { return news_; }
  /// What staff should know, a line each, once.
  std::vector<std::string> remarks();
  std::vector<Problem> problems() { return watch_.problems(); }

 private:
  struct InUse {
    std::shared_ptr<device::HidLink> link;
    device::HidHand* hand = nullptr;  ///< Attached; null for a dial, or where both hands are taken.
    int index = -1;                   ///< The hand that it is.
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

  loop::PotterHost& potter_;
  Options options_;
  device::DeviceWatch watch_;
  std::vector<InUse> used_;
  screens::DeviceNews news_;
  std::vector<std::string> remarks_;
  double looked_at_ = -1.0, buzzed_at_ = -1.0, last_frame_ = 0.0;
  double share_ = 1.0;  ///< The visitor's.
  bool touching_ = false;
  std::uint64_t moves_ = 0;
  std::uint32_t buzzes_ = 0;
};

}  // namespace onggi::exhibit
