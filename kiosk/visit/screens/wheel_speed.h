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
  static constexpr double kFirst = 25.0;   ///< rad/s: about 240 turns a minute.
  static constexpr double kStep = 2.5;     ///< rad/s
  static constexpr double kLaying = 3.5;   ///< rad/s: a ring of coil in 1.8 s.
  static constexpr double kBeating = 2.0;  ///< rad/s: nine blows of the paddle in a turn.

  explicit WheelSpeed(const Desk& desk) : asked_(std::min(kFirst, desk.wheel().max_speed)) {}
  /// True if `control` was one of its two buttons; it then sends the speed.
  bool press(std::string_view control, const Desk& desk) {
    const bool faster = control == "throw.faster";
    if (!faster && control != "throw.slower") return false;
    const double step = slow_ ? 0.5 * kBeating : kStep;
    asked_ = std::clamp(asked_ + (faster ? step : -step), 0.0,
                        slow_ ? most_slow_ : desk.wheel().max_speed);
    if (!faster && asked_ < 0.5 * step) asked_ = 0;
    send(desk);
    return true;
  }
  /// A left hand's wheel turns the other way.
  void send(const Desk& desk) const {
    desk.world.wheel_commands->wheel(desk.screen().left_handed ? -asked_ : asked_);
  }
  double asked() const { return asked_; }  ///< rad/s
  /// A coil or a paddle is taken up: from now on the wheel turns at `usual`, and visitors may
  /// choose up to `most`, rad/s.
  void slow(double usual, double most, const Desk& desk) {
    if (!slow_) fast_ = asked_;
    slow_ = true;
    most_slow_ = std::min(most, desk.wheel().max_speed);
    asked_ = std::min(usual, most_slow_);
    send(desk);
  }
  /// It is put away: the speed of before.
  void fast(const Desk& desk) {
    if (!slow_) return;
    slow_ = false;
    asked_ = fast_;
    send(desk);
  }

 private:
  double asked_, fast_ = kFirst, most_slow_ = kLaying;
  bool slow_ = false;
};

}  // namespace onggi::screens
