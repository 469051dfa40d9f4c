#pragma once

#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// Two visitors at one wheel, a finger each on the screen. The left one draws the wall's inside and
/// the right one its outside, both from the foot to the rim at the same time, stroke after stroke,
/// towards the outline on the screen. Deterministic; knows nothing of the engine. Main thread.
class TwoPlayerScript {
 public:
  static constexpr double kStroke = 9.0, kRest = 1.5;  ///< s of a stroke, and s between two.
  static constexpr int kStrokes = 9;
  static constexpr double kSeconds = kStrokes * (kStroke + kRest);

  /// Their input in the frame at `now`, s since they began; rising.
  std::vector<view::InputEvent> step(double now, const screens::WheelSnapshot& sight);
  bool done(double now) const { return now > kSeconds && !down_; }

 private:
  bool down_ = false;
};

}  // namespace onggi::rehearsal
