#pragma once

namespace onggi::screens {

/// Water is a switch for a tap, and a held sponge for a long press. It knows when water would help.
class WaterButton {
 public:
  static constexpr double kSoakHold = 0.6;  ///< s: a longer press is a held sponge.
  static constexpr double kDry = 20.0;      ///< s on dry clay until water would help,
  static constexpr double kAsk = 6.0;       ///< and s more in which the words ask for it.

  bool wet() const { return wet_; }
  void set(bool on) { wet_ = on; }
  /// Pressed at `now`, s.
  void hold(double now);
  /// Released, or pressed by a key.
  void press(double now);

  /// Call once a frame of `dt` s: whether a hand `rubs` the clay, which has `wetness` 0..1.
  void look(bool rubs, double wetness, double dt);
  bool would_help() const { return dry_ > kDry; }
  bool asked_for() const { return would_help() && dry_ < kDry + kAsk; }

 private:
  bool wet_ = false, was_wet_ = false;
  double down_at_ = -1;  ///< Below 0: not pressed.
  double dry_ = 0;       ///< s of rubbing dry clay.
};

}  // namespace onggi::screens
