#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/wheel/device/device_kind.h"

namespace onggi::screens {

/// Tells visitors about the devices under their hands: one was plugged in or removed, or a new
/// force device must be held. Shown for a few seconds while play goes on.
class DeviceNews {
 public:
  void device_added(device::DeviceKind kind, bool force);
  void device_removed(device::DeviceKind kind);
  /// Call once a frame. `hold`: a device must be held before it pushes.
  void update(double now, bool hold);

  /// Language key of the current news; empty: none.
  const std::string& key() const { return key_; }
  /// Call once a frame: the device of the first hand, and whether any device pushes.
  void device_in_use(std::optional<device::DeviceKind> first_hand, bool pushes);
  /// Language key of the device in use; empty: a finger, or none.
  const std::string& in_use() const { return in_use_; }
  /// Its kind's name: "space_mouse"; empty: a finger, or none.
  const std::string& hand() const { return hand_; }
  /// True if a device that pushes is plugged in.
  bool pushes() const { return pushes_; }
  /// Every possible result of key(), for reserving space.
  static std::vector<std::string> keys();

 private:
  std::string key_, next_, in_use_, hand_;
  double told_at_ = 0.0;
  bool had_force_ = false;  ///< There was a force device before,
  bool pushes_ = false;
  bool again_ = false;  ///< and one has come back since.
};

}  // namespace onggi::screens
