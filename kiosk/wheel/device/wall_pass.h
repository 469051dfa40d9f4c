#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "engine/clay/clay_view.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::device {

/// Limits how far hands move a wall in one pass, as potters open and collar a pot: pass by pass, no
/// deeper than soft clay can follow without a ridge, wherever the pointer is. Hands ease into the
/// clay along their way, and out of it when released: going straight to the depth would leave a
/// step. When they return over a place they have just worked, they even it. Hands that stay at a
/// height press on. Remembers the wall at the start of the pass and knows no target. Allocates
/// nothing; main thread.
class WallPass {
 public:
  /// m that a pass moves the face at most if the wall is thin, and m for a pass back over it.
  static constexpr double kDeepest = 0.009, kEvening = 0.002;
  /// The limit for a thick wall: this share of its thickness, at most kMost m. A lump is opened in
  /// large steps, a thin wall is worked gently.
  static constexpr double kOfThickness = 1.8, kMost = 0.020;
  /// m/s at which hands that stay at a height press on, after a pause of kStay / kPressOn. Without
  /// the pause a stroke that turns back slowly would dent the wall. Moving along the wall uses the
  /// allowance up.
  static constexpr double kPressOn = 0.01, kStay = 0.003;
  /// m up and down over which the wall is averaged, so that a hand carries no ridge along.
  static constexpr double kSeen = 0.020;
  /// m of reverse motion that count as a new pass and not as a tremble.
  static constexpr double kBack = 0.006;
  /// Depth per metre along the wall; m/s of depth in addition; and the way (m) and time (s) over
  /// which the depth changes. Corners of a drawn line are wider than that, and a finger's tremble
  /// is narrower.
  static constexpr double kSlope = 0.5, kDeeper = 0.02, kSoftWay = 0.010, kSoftTime = 0.15;
  /// m of way in which released hands come out of the clay; less after a shallow press: at most
  /// twice their depth.
  static constexpr double kOut = 0.020;

  /// Takes hold of `clay` at `height`, m, and starts the first pass.
  void begin(const WallHold& hold, const ClayView& clay, double height);
  /// The hands are at `height` now, `dt` s after the last call, and the face should be `reach` from
  /// the axis, m; nothing: where the pass found it.
  void go(const WallHold& hold, const ClayView& clay, double height, std::optional<double> reach,
          double dt);
  /// From now on the hands only come out of the clay as they move along it.
  void ease_out();
  /// True when they are out, or had nothing to come out of.
  bool out() const;
  /// Wanted radius of the worked face now, m.
  double reach() const { return stood_.radius + depth_; }
  /// The radius that this pass can reach if `reach` is wanted, m.
  double within(double reach) const;
  /// Passes that went back, since begin().
  int backs() const { return backs_; }

 private:
  static constexpr std::size_t kLooks = 129;
  void remember(const WallHold& hold, const ClayView& clay);

  struct Look {
    double radius = 0, thickness = 0;  // m; the solid foot has none
  };
  std::array<Look, kLooks> wall_{};  // spaced evenly from wheel to rim
  Look stood_;                       // the wall at the start of the pass, where the hands are now
  double turn_ = 0, at_ = 0;         // m: farthest point of this pass, and the current one
  int up_ = 0, backs_ = 0;           // +1 upwards, -1 down, 0 not known yet
  double on_ = 0;                    // m pressed on so far; negative during the pause
  double asked_ = 0, depth_ = 0;     // m from the starting wall: requested, and smoothed
  double leaving_ = 0, eased_ = -1;  // m: depth at release; way since then, negative before
};

}  // namespace onggi::device
