#pragma once

#include <memory>

#include "engine/base/result.h"
#include "kiosk/ground/files/child_process.h"

namespace onggi::files {

/// An X server without a screen (Xvfb), for scripted visits on machines without a display. Sets
/// DISPLAY while it lives and ends the server when destroyed. The server also ends if the thread
/// that started it dies.
class VirtualDisplay {
 public:
  /// Nothing to do (nullptr) when DISPLAY or WAYLAND_DISPLAY is set. Problem when Xvfb is missing
  /// or does not start within 10 s.
  static Result<std::unique_ptr<VirtualDisplay>> ensure(int width, int height);
  ~VirtualDisplay();
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  explicit VirtualDisplay(ChildProcess server) : server_(std::move(server)) {}
  ChildProcess server_;
};

}  // namespace onggi::files
