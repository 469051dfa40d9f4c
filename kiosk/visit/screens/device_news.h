#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/wheel/device/device_kind.h"

namespace onggi::screens {

/// What visitors are told of the devices under their hands: that one came or went, and that a force
/// device plugged in anew asks to be held. Kind words for a few seconds; play goes on meanwhile.
class DeviceNews {
 public:
  void came(device::DeviceKind kind, bool force);
  void went(device::DeviceKind kind);
  /// Once a frame. `hold`: one asks to be held before it pushes.
  void update(double now, bool hold);

  /// Of the languages: what to say now. Empty: nothing.
  const std::string& key() const { return key_; }
  /// Once a frame: what moves the first hand, and whether any device pushes.
  void use(std::optional<device::DeviceKind> first_hand, bool pushes);
  /// Of the languages: which device is in use. Empty: a finger, or nothing.
  const std::string& in_use() const { return in_use_; }
  /// Its kind's name: "space_mouse". Empty likewise.
  const std::string& hand() const { return hand_; }
  /// A device that pushes is plugged in.
  bool pushes() const { return pushes_; }
  /// Every key of key() that there can be, for reserving room.
  static std::vector<std::string> keys();

 private:
  std::string key_, next_, in_use_, hand_;
  double told_at_ = 0.0;
  bool had_force_ = false;  ///< A force device was here before,
  bool pushes_ = false;
  bool again_ = false;  ///< and one has come back since.
};

}  // namespace onggi::screens
