#pragma once

#include <atomic>
#include <memory>

#include "engine/force/haptics.h"
#include "kiosk/wheel/device/hand_device.h"
#include "kiosk/wheel/device/hid_link.h"
#include "kiosk/wheel/device/report_interpolation.h"

namespace onggi::device {

/// The loop's side of a visitor's hand at a HID device: samples become the tool's position, and the
/// clay's force becomes a request. A handle's position is mapped from its workspace to the vessel,
/// with a clutch if the workspace is too small. The tool hangs on the handle by the stiffest
/// coupling that the device can bear. A puck or stick sets the tool's speed, and a released puck
/// lifts the tool.
class HidHand final : public HandDevice {
 public:
  /// `left_handed`: it starts on the other side of the wheel.
  explicit HidHand(std::shared_ptr<HidLink> link, bool left_handed = false);
  HandInput read(double dt) noexcept override;
  void feel(const HandFeedback& feedback) noexcept override;
  double age() const noexcept override;

  HidLink& link() { return *link_; }
  /// Any thread: it moves the hand now.
  bool in_use() const { return moves_.load(std::memory_order_relaxed); }
  /// Main thread: the visitor's share of the force, 0 (off) .. 1.
  void share(double of_force) { share_.store(of_force, std::memory_order_relaxed); }

 private:
  Vec3 handle_place(double dt) noexcept;
  Vec3 glide(double dt) noexcept;
  bool in_use(double dt) noexcept;
  void turn_tool(double dt, HandInput& hand) noexcept;

  std::shared_ptr<HidLink> link_;
  DeviceDef def_;
  Vec3 home_;
  DeviceSample sample_;
  ForceRequest wish_;
  bool pushes_;  ///< A force device.
  force::HapticLimits limits_;
  bool struck_ = false;  ///< Its blow was felt.
  force::Haptics haptics_;
  ReportInterpolation join_;
  std::atomic<double> share_{1.0};
  std::atomic<bool> moves_{false};
  Vec3 at_;             ///< The hand, or a puck's tool, as last read.
  Vec3 tool_;           ///< The tool on a force device.
  Vec3 speed_;          ///< Speed of a puck's tool, m/s.
  Vec3 clutch_offset_;  ///< Offset from the clutch, metres.
  Vec3 handle_;         ///< HandInput::handle, once it was turned.
  double roll_ = 0.0;
  double idle_time_ = 1e9;  ///< s since a puck was last touched.
  bool clutched_ = false, used_ = false;
};

}  // namespace onggi::device
