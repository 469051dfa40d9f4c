#pragma once

#include <vector>

#include "kiosk/picture/view/input.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::rehearsal {

/// Two visitors at one wheel, a finger each on the glass: the one on the left draws where the
/// wall's inside shall be, the one on the right where its outside shall be, both from the foot to
/// the rim and at the same time, stroke after stroke, towards what they have before their eyes.
/// Deterministic; knows nothing of the engine. Main thread.
class TwoVisitors {
 public:
  static constexpr double kStroke = 9.0, kRest = 1.5;  ///< s of a stroke, and until the next.
  static constexpr int kStrokes = 9;
  static constexpr double kSeconds = kStrokes * (kStroke + kRest);

  /// What they do in the frame at `now`, s since they began; rising.
  std::vector<view::InputEvent> step(double now, const screens::Sight& sight);
  bool done(double now) const { return now > kSeconds && !down_; }

 private:
  bool down_ = false;
};

}  // namespace onggi::rehearsal
