#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/wheel/device/hid_port.h"

namespace onggi::stand_in {

using Bytes = std::vector<std::uint8_t>;

/// A device on its wire protocol: what it sends as its time passes, and what it makes of what it is
/// told. Knows no clock; its world turns it.
class SimulatedDevice {
 public:
  virtual ~SimulatedDevice() = default;
  /// As the system lists it; the world adds the path.
  virtual device::HidListing listing() const = 0;
  /// A millisecond passes. What it sends in it, if anything.
  virtual std::optional<Bytes> tick() = 0;
  /// It was told something. False: it does not take that.
  virtual bool take(const Bytes& report) = 0;
  virtual std::optional<Bytes> feature(std::uint8_t /*id*/) { return std::nullopt; }
  /// The cable goes, or comes back.
  virtual void plug(bool /*in*/) {}
};

}  // namespace onggi::stand_in
