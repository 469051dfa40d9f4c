#pragma once

#include <optional>

#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// What is looked at from all sides: how far it was turned by a finger that goes from side to side,
/// by the arrows of a keyboard that is on it, or by presses of one switch; and whether it stands
/// still for that, where it else turns by itself. Knows no clock or pot. Main thread.
class Turntable {
 public:
  static constexpr double kAnArrow = 3.14159265358979 / 18;  ///< rad by a press of an arrow,
  static constexpr double kAPress = 3.14159265358979 / 4;    ///< and of Enter or the switch,
  static constexpr double kRest = 6.0;                       ///< after which it stands, s.

  /// A finger or a mouse that is on no control; `half_turn`: pixels that it goes for that.
  void pointer(const view::InputEvent& event, float half_turn);
  /// What faces the eye goes to the right, or to the left, as under a finger.
  void by_arrow(bool to_the_right);
  /// An eighth of a turn the way that it turns by itself: `speed`'s sign.
  void press(double speed, double now);
  /// Once a frame: the keyboard is on it, or not.
  void keyed(bool on) { keyed_ = on; }
  /// Nothing turns it but the visitor.
  bool stands(double now) const { return dragged_ || keyed_ || now < rests_until_; }
  /// rad, from 0 on; positive as a wheel for the right hand turns.
  double angle() const { return angle_; }

 private:
  void turn(double by);

  double angle_ = 0, rests_until_ = -1;
  std::optional<float> dragged_;  ///< Where the finger was, pixels.
  bool keyed_ = false;
};

}  // namespace onggi::screens
