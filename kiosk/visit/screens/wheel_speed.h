#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// The visitor's wheel speed: the wheel starts by itself, so that touch works at once, and two
/// buttons change it in steps. Who pushes the wheel head takes it over: then it runs down by its
/// bearing, and the buttons (or a dial) push and brake it. Once it stands, they start the motor
/// again.
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
    if (asked_ == 0) coasts_ = false;
    asked_ = std::clamp(asked_ + (faster ? step : -step), 0.0, most(desk));
    if (!faster && asked_ < 0.5 * step) asked_ = 0;
    send(desk);
    return true;
  }
  /// A left hand's wheel turns the other way.
  void send(const Desk& desk) const {
    desk.world.wheel_commands->wheel(desk.screen().left_handed ? -asked_ : asked_);
  }
  double asked() const { return asked_; }  ///< rad/s
  /// Somebody works by buttons: a wheel that was pushed and stands gets its motor back.
  void start(const Desk& desk) {
    if (!coasts_ || asked_ > 0) return;
    coasts_ = false;
    asked_ = std::min(slow_ ? own_[static_cast<std::size_t>(*slow_)] : kFirst, most(desk));
    send(desk);
  }
  /// A hand on the wheel head turns it at `speed` (rad/s, from x towards z): along, or it brakes.
  void push(double speed, const Desk& desk) {
    coasts_ = true;
    asked_ = std::clamp(desk.screen().left_handed ? -speed : speed, 0.0, most(desk));
    send(desk);
  }
  /// Call once a frame, of `dt` s, while no hand is on the wheel head.
  void run_down(double dt, const Desk& desk) {
    if (!coasts_ || asked_ == 0) return;
    asked_ -= (kBearing + asked_ / kAir) * dt;
    if (asked_ < kStands) asked_ = 0;
    send(desk);
  }
  /// Ways of working on a slow wheel. Each keeps the speed that the visitor gave it.
  enum class Slowly : std::uint8_t { laying, beating };
  /// A coil or a paddle is taken up: visitors may choose up to `most`, rad/s.
  void slow(Slowly way, double most, const Desk& desk) {
    keep(desk);
    slow_ = way;
    coasts_ = false;
    most_slow_ = std::min(most, desk.wheel().max_speed);
    asked_ = std::min(own_[static_cast<std::size_t>(way)], most_slow_);
    send(desk);
  }
  /// It is put away: the speed of before.
  void fast(const Desk& desk) {
    if (!slow_) return;
    keep(desk);
    slow_.reset();
    coasts_ = false;
    asked_ = fast_;
    send(desk);
  }

 private:
  // A wheel of wood runs from 33 turns a minute to rest in a quarter of a minute. Estimates.
  static constexpr double kBearing = 0.15;  // rad/s^2
  static constexpr double kAir = 20.0;      // s: what grows with the speed
  static constexpr double kStands = 0.15;   // rad/s
  // What a push left is nobody's choice.
  void keep(const Desk& desk) {
    if (coasts_)
      fast_ = slow_ ? fast_ : std::min(kFirst, desk.wheel().max_speed);
    else
      (slow_ ? own_[static_cast<std::size_t>(*slow_)] : fast_) = asked_;
  }
  double most(const Desk& desk) const { return slow_ ? most_slow_ : desk.wheel().max_speed; }

  double asked_, fast_ = kFirst, most_slow_ = kLaying;
  std::array<double, 2> own_{kLaying, kBeating};  ///< By Slowly.
  std::optional<Slowly> slow_;
  bool coasts_ = false;
};

}  // namespace onggi::screens
