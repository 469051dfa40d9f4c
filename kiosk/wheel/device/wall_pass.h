#pragma once

#include <array>
#include <cstddef>

#include "engine/clay/clay_view.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::device {

/// How far hands move a wall in one pass, as potters open and collar a pot: pass by pass, and no
/// deeper than soft clay follows without a ridge, wherever the pointer is meanwhile. They ease into
/// the clay along their way and, let go of, out of it: a hand that comes to its depth on the spot
/// leaves a step. Where they come back over what they have just worked, to and fro, they even it.
/// Who lingers at a height presses on. Remembers the wall as it stood when the pass began; nothing
/// is known here of any target. Allocates nothing; main thread.
class WallPass {
 public:
  /// m that a pass moves the face at the most, where the wall is thin; and one that comes back over
  /// it.
  static constexpr double kDeepest = 0.009, kEvening = 0.002;
  /// Of the wall's thickness, where that is more, and m at the most: a lump is opened in large
  /// steps, a wall that is thin already is worked gently.
  static constexpr double kOfThickness = 1.8, kMost = 0.020;
  /// m/s by which hands that stay at a height press on, once they have stayed for kStay / kPressOn:
  /// a stroke that turns back slowly would dent the wall there. Along the wall they use it up.
  static constexpr double kPressOn = 0.01, kStay = 0.003;
  /// m up and down over which the wall is seen: a hand carries no ridge along.
  static constexpr double kSeen = 0.020;
  /// m back down, or up again, that are another pass and no tremble.
  static constexpr double kBack = 0.006;
  /// Depth for each way along the wall, m/s of it beside that, and the way and time, m and s, over
  /// which it changes: a drawn line's corners, and a finger's tremble, are wider than that or none.
  static constexpr double kSlope = 0.5, kDeeper = 0.02, kSoftWay = 0.010, kSoftTime = 0.15;
  /// m of way in which hands that are let go of come out of the clay: twice their depth, at most.
  static constexpr double kOut = 0.020;

  /// Hands take hold of `clay` at `height`, m: a first pass.
  void begin(const WallHold& hold, const ClayView& clay, double height);
  /// They are at `height` now, `dt` s after the last time, and the face is wanted `reach` from the
  /// axis, m.
  void go(const WallHold& hold, const ClayView& clay, double height, double reach, double dt);
  /// From now on they only come out of the clay as they go along it, however they are wanted.
  void ease_out();
  /// They have, or had nothing to come out of.
  bool out() const;
  /// How far from the axis the worked face is to be by now, m.
  double reach() const { return stood_.radius + depth_; }
  /// How far from the axis it comes in this pass where `reach` is wanted, m.
  double within(double reach) const;
  /// Passes that came back, since begin().
  int backs() const { return backs_; }

 private:
  static constexpr std::size_t kLooks = 129;
  void remember(const WallHold& hold, const ClayView& clay);

  struct Look {
    double radius = 0, thickness = 0;  // m; none of the solid foot
  };
  std::array<Look, kLooks> wall_{};  // evenly from wheel to rim
  Look stood_;                       // of it, where the hands are now
  double turn_ = 0, at_ = 0;         // m: the farthest on this pass, and now
  int up_ = 0, backs_ = 0;           // +1 upwards, -1 down, 0 not known yet
  double on_ = 0;                    // m pressed on; below 0 before it begins
  double asked_ = 0, depth_ = 0;     // m from where it stood: rising evenly, and softened
  double leaving_ = 0, eased_ = -1;  // m: the depth they come out of; way since, below 0 before it
};

}  // namespace onggi::device
