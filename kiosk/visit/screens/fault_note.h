#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/wheel/loop/status.h"
#include "kiosk/wheel/loop/wheel_commands.h"

namespace onggi::screens {

/// Tells visitors in kind words, for a few seconds, that the wheel had to correct something under
/// their hand (FaultBit). A shown fault is acknowledged at the wheel, so that a repeat is shown
/// again.
class FaultNote {
 public:
  void update(const loop::LoopStatus& status, double now, loop::WheelCommands& wheel_commands);
  /// Language key of the current message; empty: none.
  const std::string& key() const { return key_; }
  /// Every possible key, for reserving space.
  static std::vector<std::string> keys();

 private:
  std::string key_;
  double told_at_ = 0;
};

}  // namespace onggi::screens
