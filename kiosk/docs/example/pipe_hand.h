#pragma once

#include <atomic>
#include <thread>

#include "kiosk/wheel/device/force_gate.h"
#include "kiosk/wheel/device/hand_device.h"
#include "kiosk/wheel/device/mailbox.h"

namespace onggi::example {

/// A hand whose driver is another program: poses come in over one pipe, forces go out over another.
/// A lab copies this file and puts its maker's library in the place of the pipes.
class PipeHand final : public device::HandDevice {
 public:
  /// `poses` gives lines "x y z held", metres and 0 or 1; `forces` gets a line "fx fy fz", newtons,
  /// for each. Both are file descriptors; they become this object's.
  PipeHand(int poses, int forces, const device::ForceLimits& limits);
  ~PipeHand() override;

  // The loop's thread: no call of these waits, allocates or writes.
  HandInput read(double dt) noexcept override;
  void feel(const HandFeedback& feedback) noexcept override;

 private:
  struct Pose {
    Vec3 at;
    bool held = false;
  };
  struct Wish {
    Vec3 force;
    double ticks = 0.0;
  };
  void run();

  int poses_, forces_;
  device::ForceLimits limits_;
  device::Mailbox<Pose> pose_;
  device::Mailbox<Wish> wish_;
  Pose newest_;  ///< The loop's.
  Wish mine_;    ///< The loop's.
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace onggi::example
