#pragma once

#include <algorithm>
#include <string_view>
#include <utility>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// The visitor's wheel speed: the wheel starts by itself, so that touch works at once, and two
/// buttons change it in steps.
class WheelSpeed {
 public:
  static constexpr double kFirst = 25.0;  ///< rad/s: about 240 turns a minute.
  static constexpr double kStep = 2.5;    ///< rad/s
  static constexpr double kLaying = 2.5;  ///< rad/s: a ring of coil in 2.5 s.

  explicit WheelSpeed(const Desk& desk) : asked_(std::min(kFirst, desk.wheel().max_speed)) {}
  /// True if `control` was one of its two buttons; it then sends the speed.
  bool press(std::string_view control, const Desk& desk) {
    const bool faster = control == "throw.faster";
    if (!faster && control != "throw.slower") return false;
    const double step = laying_ ? 0.5 * kLaying : kStep;
    asked_ = std::clamp(asked_ + (faster ? step : -step), 0.0,
                        laying_ ? most_laying_ : desk.wheel().max_speed);
    if (!faster && asked_ < 0.5 * step) asked_ = 0;
    send(desk);
    return true;
  }
  /// A left hand's wheel turns the other way.
  void send(const Desk& desk) const {
    desk.world.wheel_commands->wheel(desk.screen().left_handed ? -asked_ : asked_);
  }
  double asked() const { return asked_; }  ///< rad/s
  /// A coil is taken up, or put away: each way of working has its speed. `most`: with a coil,
  /// rad/s.
  void lay(bool on, double most, const Desk& desk) {
    most_laying_ = std::min(most, desk.wheel().max_speed);
    if (std::exchange(laying_, on) != on)
      std::swap(asked_, other_);
    else if (!on)
      return;
    if (on) asked_ = std::min(asked_, most_laying_);
    send(desk);
  }

 private:
  double asked_, other_ = kLaying, most_laying_ = kLaying;
  bool laying_ = false;
};

}  // namespace onggi::screens
