#pragma once

#include <memory>
#include <optional>

#include "kiosk/wheel/device/device_def.h"
#include "kiosk/wheel/device/device_sample.h"
#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

/// What its link lets a driver say.
struct Saying {
  bool may_push = false;  ///< A person holds it, and nothing is wrong.
  Vec3 force;             ///< From the gate, N, the device's frame; zero unless it is armed.
  double cap = 0;         ///< N
  double damping = 0;     ///< N s/m
  FeelWish wish;          ///< For devices that tremble and buzz.
  std::int64_t now_ns = 0;
};

/// One device's protocol: bytes to a sample, wishes to bytes. Called by its link's thread alone
/// (begin() and end() while there is none). Nothing after begin() allocates or throws.
class Driver {
 public:
  virtual ~Driver() = default;
  /// Shakes hands, and leaves the device without force. False: it is not what its numbers say.
  virtual bool begin(HidPort& port) = 0;
  /// One report into `sample`: place or deflection, buttons, dial, what a hand sensor says.
  virtual Heard take(Report report, DeviceSample& sample) noexcept = 0;
  /// What to write now; empty: nothing. Good until the next call.
  virtual Report say(const Saying& saying) noexcept = 0;
  /// No force, no light, no trembling.
  virtual void end(HidPort& port) noexcept = 0;
  /// It has a sensor for a hand: sample.held is its own word.
  virtual bool feels_hand() const noexcept { return false; }
  /// It does not answer to what it was sent.
  virtual bool deaf() const noexcept { return false; }
  /// What it says of itself, for lists: "5.0 N, firmware 1.2". Empty where it says nothing.
  virtual std::string says() const { return {}; }
  /// The most that it can push, N, where it says so.
  virtual std::optional<double> greatest_force() const noexcept { return std::nullopt; }
};

std::unique_ptr<Driver> make_driver(DeviceKind kind, const HidListing& listing,
                                    const DeviceDef& def);

}  // namespace onggi::device
