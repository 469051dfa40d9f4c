#pragma once

#include <memory>

#include "engine/script/script.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::rehearsal {

/// Performs a script like a person: frame by frame with the pointer, or only wheel and water while
/// a device moves the hand. It takes time between strokes, as people do when they move a tool. Main
/// thread.
class VisitorsHand {
 public:
  enum class By : std::uint8_t { pointer, device };
  static constexpr double kCarry = 2.4;  ///< s from one stroke to the next.

  VisitorsHand(std::unique_ptr<Script> script, By by) : script_(std::move(script)), by_(by) {}
  /// Call once a frame, `dt` seconds after the last. False if the wheel did not answer.
  bool step(double dt, loop::WheelHost& wheel_host);
  double progress() const { return time_ / script_->duration(); }
  bool done() const { return time_ >= script_->duration(); }

 private:
  std::unique_ptr<Script> script_;
  By by_;
  double time_ = 0.0;     ///< Of the script.
  double carried_ = 0.0;  ///< s that the tool has been in the air.
  bool down_ = false;
};

}  // namespace onggi::rehearsal
