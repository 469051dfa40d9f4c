#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "kiosk/wheel/device/codecs/wire_bytes.h"

namespace onggi::device {

/// One HID interface as the system lists it.
struct HidListing {
  std::string path;  ///< Argument for open(): "/dev/hidraw3".
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t usage_page = 0, usage = 0;
  bool bluetooth = false;
  std::string name, serial;  ///< UTF-8, as the device reports them.
};

/// An open device. Only one thread at a time: in hidapi 0.13 both read and write free the same
/// string.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// Waits up to `timeout_ms` (0: not at all) for one report. Returns its bytes; 0: none came; -1:
  /// the device is gone.
  virtual int read(std::span<std::uint8_t> into, int timeout_ms) noexcept = 0;
  /// False if the device did not take it.
  virtual bool write(Report report) noexcept = 0;
  /// Reads feature `id` into `into`, whose first byte becomes the id. Returns its bytes, or -1.
  virtual int feature(std::uint8_t id, std::span<std::uint8_t> into) noexcept = 0;
};

/// Lists and opens devices. One thread at a time for both.
class HidBus {
 public:
  virtual ~HidBus() = default;
  virtual std::vector<HidListing> list() = 0;
  /// Accepts only a path from list(). Null if it cannot be opened.
  virtual std::unique_ptr<HidPort> open(const std::string& path) = 0;
};

}  // namespace onggi::device
