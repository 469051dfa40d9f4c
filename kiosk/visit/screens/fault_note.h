#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/wheel/loop/potter.h"
#include "kiosk/wheel/loop/status.h"

namespace onggi::screens {

/// What the wheel had to put right beneath the visitor's hand (FaultBit), told in kind words for a
/// few seconds. What is told is forgotten at the wheel, so that it is told again should it return.
class FaultNote {
 public:
  /// Once a frame.
  void update(const loop::LoopStatus& status, double now, loop::PotterCommands& potter);
  /// Of the languages: what to say now. Empty: nothing.
  const std::string& key() const { return key_; }
  /// Every key that there can be, for reserving room.
  static std::vector<std::string> keys();

 private:
  std::string key_;
  double told_at_ = 0;
};

}  // namespace onggi::screens
