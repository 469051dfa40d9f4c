#pragma once

#include "engine/force/decorating_tool.h"
#include "engine/force/leather_outline.h"
#include "engine/force/tool_touch.h"

namespace onggi::force {

/// How a leather-hard pot stands on the wheel.
struct LeatherTurn {
  double angle = 0.0;  ///< rad, of the pot's own angle 0 from x towards z.
  double speed = 0.0;  ///< rad/s
};

/// Where a hand's tool is at the pot.
struct LeatherPlace {
  bool near = false;     ///< A tool is in a hand, and there is a wall.
  bool contact = false;  ///< It touches.
  double along = 0.0;    ///< From the foot along the outline, m.
  double turns = 0.0;    ///< Round the pot from its own angle 0, 0..1.
  double depth = 0.0;    ///< m; below 0: so far off the wall.
};

/// One hand's decorating tool at a leather-hard wall, from tick to tick. A tool that arrives within
/// the clay meets no wall until it was clear of it, so no hand is thrown out; one that is pushed
/// through by more than kThrough is let go in the same way. No allocation; one thread.
class LeatherHand {
 public:
  static constexpr double kClear = 5e-4;    ///< m in the clay: still as good as outside.
  static constexpr double kThrough = 0.03;  ///< m
  static constexpr double kReach = 0.012;  ///< m along the wall that a touching tool may go a tick.

  /// The tool is at `at` (m); `share`, 0..1, of its force is felt. Returns what it meets there, for
  /// Haptics.
  Touch meet(const LeatherOutline& wall, const DecoratingTool& tool, Vec3 at, double share,
             const LeatherTurn& turn) noexcept;
  const LeatherPlace& place() const { return place_; }
  /// The hand was lifted, or is somewhere else.
  void release() noexcept { *this = LeatherHand(); }

 private:
  LeatherPlace place_;
  bool cleared_ = false;
};

}  // namespace onggi::force
