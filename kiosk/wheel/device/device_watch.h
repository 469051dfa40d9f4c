#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/wheel/device/hid_link.h"

namespace onggi::device {

/// Finds new devices: lists the plugged-in ones every second, and opens those with a driver. Only
/// this class lists and opens, on one thread, as hidapi 0.13 requires. A device's link notices its
/// removal.
class DeviceWatch {
 public:
  using Define = std::function<DeviceDef(DeviceKind)>;

  /// With Turning::by_hand there is no thread, and the caller calls look(). `define` returns the
  /// settings of a kind; called on the watch's thread.
  DeviceWatch(std::unique_ptr<HidBus> bus, HidLink::Turning turning, Define define);
  ~DeviceWatch();
  DeviceWatch(const DeviceWatch&) = delete;
  DeviceWatch& operator=(const DeviceWatch&) = delete;

  /// Main thread: links that have begun since the last call.
  std::vector<std::unique_ptr<HidLink>> arrived();
  /// Main thread: the link of `path` is gone; a device there now counts as new.
  void gone(const std::string& path);
  /// Main thread: why devices cannot be used, once for each time one is plugged in.
  std::vector<Problem> problems();
  /// Without a thread: looks once, now.
  void look();

 private:
  void run();
  void open(const HidListing& listing, DeviceKind kind);

  std::unique_ptr<HidBus> bus_;
  HidLink::Turning turning_;
  Define define_;
  std::set<std::string> reported_;  ///< Watch's thread only: paths that could not be used.

  std::mutex mutex_;  ///< Guards the members below.
  std::condition_variable stop_soon_;
  std::set<std::string> open_;
  std::vector<std::unique_ptr<HidLink>> arrived_;
  std::vector<Problem> problems_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace onggi::device
