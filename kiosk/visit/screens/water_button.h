#pragma once

namespace onggi::screens {

/// Water is a switch for a tap, and a held sponge for a long press.
class WaterButton {
 public:
  static constexpr double kSoakHold = 0.6;  ///< s: a longer press is a held sponge.

  bool wet() const { return wet_; }
  void set(bool on) { wet_ = on; }
  /// Pressed at `now`, s.
  void hold(double now);
  /// Released, or pressed by a key.
  void press(double now);

 private:
  bool wet_ = false, was_wet_ = false;
  double down_at_ = -1;  ///< Below 0: not pressed.
};

}  // namespace onggi::screens
