#pragma once

#include <array>
#include <optional>
#include <utility>

#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// Turns an object that is seen from all sides: by a finger that moves sideways, by arrow keys
/// while the keyboard is on it, or by presses of one switch. Two fingers turn and tilt it. Also
/// decides whether the automatic turning pauses. Knows no clock or pot. Main thread.
class Turntable {
 public:
  static constexpr double kAnArrow = 3.14159265358979 / 18;  ///< rad for an arrow key,
  static constexpr double kAPress = 3.14159265358979 / 4;    ///< and for Enter or the switch,
  static constexpr double kRest = 6.0;                       ///< s of pause after that.

  /// A finger or a mouse that is on no control; `half_turn`: pixels for half a turn.
  void pointer(const view::InputEvent& event, float half_turn);
  /// The same for two fingers of a touch screen; sees every pointer event first. True if the event
  /// is theirs: from the second finger's touch on, until both have left.
  bool pair(const view::InputEvent& event, float half_turn);
  /// The screen is left or covered: no finger is on it any more.
  void let_go();
  /// rad that the eye was raised, kLeastTilt..kMostTilt.
  double tilt() const { return tilt_; }
  static constexpr double kLeastTilt = -0.25, kMostTilt = 0.7;
  /// Turns the front to the right or left, like a finger.
  void by_arrow(bool to_the_right);
  /// Turns by an eighth in the direction of the automatic turning: `speed`'s sign.
  void press(double speed, double now);
  /// Call once a frame: whether the keyboard is on it.
  void keyed(bool on) { keyed_ = on; }
  /// True while only the visitor turns it.
  bool stands(double now) const { return dragged_ || paired_ || keyed_ || now < rests_until_; }
  /// rad, from 0 on; positive like a wheel for the right hand.
  double angle() const { return angle_; }

 private:
  void turn(double by);

  double angle_ = 0, tilt_ = 0, rests_until_ = -1;
  std::optional<float> dragged_;  ///< Last position of the finger, pixels.
  bool keyed_ = false;
  std::array<std::optional<std::pair<float, float>>, 10> fingers_;  ///< On the glass, pixels.
  bool paired_ = false;
};

}  // namespace onggi::screens
