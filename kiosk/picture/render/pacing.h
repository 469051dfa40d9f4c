#pragma once

namespace onggi::render {

/// Chooses the render scale of the 3-D picture from measured frame times. The scale shrinks when
/// frames are late, and grows only when there is plenty of time. The dead zone between lets it
/// settle. Plain numbers; knows no clock.
class Pacing {
 public:
  static constexpr double kLeast = 0.35, kMost = 1.0;

  /// Frames longer than `late_ms` shrink the scale; frames shorter than `idle_ms` (< late_ms) grow
  /// it.
  Pacing(double late_ms, double idle_ms) : late_ms_(late_ms), idle_ms_(idle_ms) {}

  /// Call for each frame, which took `ms` of work at the current scale.
  void frame(double ms);
  double scale() const { return scale_; }

 private:
  double late_ms_, idle_ms_;
  double mean_ms_ = 0, scale_ = kMost;
  int since_change_ = 0, frames_ = 0;
};

}  // namespace onggi::render
