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
  std::string path;  ///< What open() takes: "/dev/hidraw3".
  std::uint16_t vendor = 0, product = 0;
  std::uint16_t usage_page = 0, usage = 0;
  bool bluetooth = false;
  std::string name, serial;  ///< UTF-8, as the device says.
};

/// An open device. One thread at a time, always: hidapi 0.13 frees one string of its own in read
/// and write alike.
class HidPort {
 public:
  virtual ~HidPort() = default;
  /// Waits up to `timeout_ms` (0: not at all) for one report. Its bytes; 0 none came; -1 the device
  /// is gone.
  virtual int read(std::span<std::uint8_t> into, int timeout_ms) noexcept = 0;
  /// False where it was not taken.
  virtual bool write(Report report) noexcept = 0;
  /// Asks for feature `id` into `into`, whose first byte becomes the id. Its bytes, or -1.
  virtual int feature(std::uint8_t id, std::span<std::uint8_t> into) noexcept = 0;
};

/// Where devices are listed and opened. One thread at a time for both.
class HidBus {
 public:
  virtual ~HidBus() = default;
  virtual std::vector<HidListing> list() = 0;
  /// Only a path that list() gave. Null where it cannot be opened.
  virtual std::unique_ptr<HidPort> open(const std::string& path) = 0;
};

}  // namespace onggi::device
