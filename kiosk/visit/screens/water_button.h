#pragma once

namespace onggi::screens {

/// Water is a switch for a tap, and a sponge for as long as it is pressed.
class WaterButton {
 public:
  static constexpr double kSoakHold = 0.6;  ///< s: a press this long is a sponge held.

  bool wet() const { return wet_; }
  void set(bool on) { wet_ = on; }
  /// It goes down at `now`, s.
  void hold(double now);
  /// It comes up, or a key pressed it.
  void press(double now);

 private:
  bool wet_ = false, was_wet_ = false;
  double down_at_ = -1;  ///< Below 0: it is up.
};

}  // namespace onggi::screens
