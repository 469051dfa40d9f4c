#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/wheel/loop/status.h"

namespace onggi::loop {

/// Turns FaultBits into log lines for staff: one line a kind and pot, however often it comes. Main
/// thread.
class FaultLog {
 public:
  /// Once a frame: a line for each new kind.
  std::vector<std::string> news(const LoopStatus& status);

 private:
  std::uint32_t scene_serial_ = 0;
  std::uint32_t told_ = 0;
};

}  // namespace onggi::loop
