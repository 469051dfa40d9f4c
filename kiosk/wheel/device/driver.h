#pragma once

#include <memory>
#include <optional>

#include "kiosk/wheel/device/device_def.h"
#include "kiosk/wheel/device/device_sample.h"
#include "kiosk/wheel/device/hid_port.h"

namespace onggi::device {

/// What a link passes to its driver for the next output.
struct DriverOutput {
  bool may_push = false;  ///< A person holds it, and there is no fault.
  Vec3 force;             ///< From the force gate, N, the device's frame; zero unless it is armed.
  double cap = 0;         ///< N
  double damping = 0;     ///< N s/m
  ForceRequest wish;      ///< For devices that vibrate and buzz.
  std::int64_t now_ns = 0;
};

/// One device's protocol: converts bytes to samples, and force requests to bytes. Only its link's
/// thread calls it (begin() and end() run without that thread). After begin(), nothing allocates or
/// throws.
class Driver {
 public:
  virtual ~Driver() = default;
  /// Does the handshake, and leaves the device without force. False: it is not the expected device.
  virtual bool begin(HidPort& port) = 0;
  /// Reads one report into `sample`: position or deflection, buttons, dial, hand sensor.
  virtual ReportResult take(Report report, DeviceSample& sample) noexcept = 0;
  /// The next output; empty: nothing. Valid until the next call.
  virtual Report say(const DriverOutput& saying) noexcept = 0;
  /// Stops force, light and vibration.
  virtual void end(HidPort& port) noexcept = 0;
  /// It has a hand sensor, so it sets sample.held itself.
  virtual bool feels_hand() const noexcept { return false; }
  /// It does not answer to output.
  virtual bool deaf() const noexcept { return false; }
  /// Its own description, for lists: "5.0 N, firmware 1.2". May be empty.
  virtual std::string says() const { return {}; }
  /// Its largest force, N, if it reports one.
  virtual std::optional<double> greatest_force() const noexcept { return std::nullopt; }
};

/// The driver of this kind of device. Allocates.
std::unique_ptr<Driver> make_driver(DeviceKind kind, const HidListing& listing,
                                    const DeviceDef& def);

/// The drivers; each is a class of its own file in drivers/.
std::unique_ptr<Driver> make_dual_sense(bool bluetooth);
std::unique_ptr<Driver> make_onggi_hid();
std::unique_ptr<Driver> make_polhem(const ArmDef& arm);
std::unique_ptr<Driver> make_space_mouse();
std::unique_ptr<Driver> make_surface_dial();

}  // namespace onggi::device
