#pragma once

#include <optional>

#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// The studio's window, which a finger draws round the pot: light that grazes a wall shows each cut
/// and ridge, as conservators look. Places are those of view::PotView::window. Main thread.
class MovedLight {
 public:
  static constexpr double kFarthest = 1.4;   ///< rad to a side,
  static constexpr double kNearWords = 0.2;  ///< and to where shadows fall towards the words.
  static constexpr double kAnArrow = 0.2;    ///< rad for an arrow key,
  static constexpr double kAPress = 0.7;     ///< and for Enter or the switch.

  /// Where it may be from now on, rad.
  void keep_within(double low, double high);
  /// A finger or a mouse that is on no control. It draws the light along, from `from` or where it
  /// was left; `across`: pixels from one side to the other.
  void pointer(const view::InputEvent& event, double from, float across);
  void by_arrow(double from, bool to_the_right);
  /// To the right, and from the farthest place there to the left again.
  void press(double from);
  /// The screen is left or covered: no finger is on it any more.
  void let_go() { dragged_.reset(); }
  bool moved() const { return at_.has_value(); }
  double at(double from) const { return at_.value_or(from); }

 private:
  void move(double to);

  double low_ = -kFarthest, high_ = kFarthest;
  std::optional<double> at_;      ///< Absent: nobody has moved it.
  std::optional<float> dragged_;  ///< Last position of the finger, pixels.
};

}  // namespace onggi::screens
