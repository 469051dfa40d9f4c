#pragma once

#include <memory>
#include <optional>

#include "kiosk/visit/decorating/example.h"
#include "kiosk/visit/decorating/touch_queue.h"
#include "kiosk/wheel/loop/status.h"
#include "kiosk/wheel/loop/wheel_commands.h"

namespace onggi::screens {

/// A hand device that leads the tool on a pot that is decorated, as a finger on the glass does:
/// touching the wall is a press, going along it a move, leaving it a lift. From the first time that
/// a visitor holds a device until this is destroyed, the clay on the wheel is leather-hard. Main
/// thread.
class LedTool {
 public:
  /// `commands` outlives it.
  explicit LedTool(loop::WheelCommands& commands) : commands_(commands) {}
  ~LedTool();
  LedTool(const LedTool&) = delete;
  LedTool& operator=(const LedTool&) = delete;

  /// Once a frame. `angle`: of the pot as it was drawn last, rad. `free`: neither a finger nor a
  /// button is at work on the pot. True if it has just touched the pot.
  bool update(const loop::LoopStatus& status, const decorating::DecoratedPot& pot, double angle,
              double dt, bool free, decorating::TouchQueue& touches);
  /// Lifts the tool; it touches again once it was off the wall.
  void let_go(decorating::TouchQueue& touches);
  bool touches() const { return leads_.has_value(); }
  /// Where it is, for drawing; nothing where no device is held, or it is far from the wall.
  const std::optional<decorating::Example::Finger>& finger() const { return finger_; }

 private:
  void harden(const surface::Surface& surface);
  std::optional<std::size_t> hand_at(const loop::LoopStatus& status) const;

  loop::WheelCommands& commands_;
  bool hard_ = false;
  int tool_ = -1;
  std::optional<double> angle_;
  std::optional<std::size_t> leads_;  ///< The hand that presses.
  bool waits_ = false;                ///< Until it is off the wall.
  std::optional<decorating::Example::Finger> finger_;
};

}  // namespace onggi::screens
