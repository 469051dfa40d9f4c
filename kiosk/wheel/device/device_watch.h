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

/// Sees devices come: lists what is plugged in every second, and opens what has a driver. Only it
/// lists and opens, on one thread, as hidapi 0.13 wants it. That a device goes, its link sees.
class DeviceWatch {
 public:
  using Define = std::function<DeviceDef(DeviceKind)>;

  /// By hand there is no thread, and look() is called instead. `define` says how a kind is used,
  /// on the watch's thread.
  DeviceWatch(std::unique_ptr<HidBus> bus, HidLink::Turning turning, Define define);
  ~DeviceWatch();
  DeviceWatch(const DeviceWatch&) = delete;
  DeviceWatch& operator=(const DeviceWatch&) = delete;

  /// Main's: links that have begun since the last call.
  std::vector<std::unique_ptr<HidLink>> arrived();
  /// Main's: the link of `path` is gone; what is plugged in there now is new.
  void gone(const std::string& path);
  /// Main's: what keeps a device from being used, once for as long as it is there.
  std::vector<Problem> problems();
  /// Where it has no thread: looks once, now.
  void look();

 private:
  void run();
  void open(const HidListing& listing, DeviceKind kind);

  std::unique_ptr<HidBus> bus_;
  HidLink::Turning turning_;
  Define define_;
  std::set<std::string> told_;  ///< The watch's own: paths that could not be used.

  std::mutex mutex_;  ///< For what follows.
  std::condition_variable stop_soon_;
  std::set<std::string> open_;
  std::vector<std::unique_ptr<HidLink>> arrived_;
  std::vector<Problem> problems_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace onggi::device
