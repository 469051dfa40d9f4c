#pragma once

#include <array>
#include <deque>
#include <optional>

#include "engine/math/vec.h"
#include "engine/scene/hands.h"
#include "kiosk/wheel/device/wall_hold.h"
#include "kiosk/wheel/device/wall_pass.h"

namespace onggi::device {

/// A finger, a mouse or arrow keys as the potter's hands, the screens' half: where the tools are to
/// be (PointerHand glides there). The hands stand in the plane through the axis that faces the
/// camera, on the side of the pot where the pointer went down. Going down sets them on the clay at
/// the pointer's height, so that they just touch. From then on they follow the line that the
/// pointer draws, at a potter's pace, corners and all: the face they work comes to be where it was
/// drawn, as far as one pass goes (WallPass). What is still to be followed when the pointer lifts,
/// they finish, and go on a little as they come out of the clay. Main thread.
class PointerLead {
 public:
  /// m/s along the wall and towards the axis or away, in clay and in the air. A pointer crosses the
  /// pot in a tenth of a second; hands as quick as that cut a screw thread.
  static constexpr double kRise = 0.05, kPress = 0.05, kAir = 0.35;
  /// m/s into the solid foot, where a hand only goes towards the pointer.
  static constexpr double kSolid = 0.01;
  /// s that the hands may be behind before they hurry, and go on for when the pointer has lifted.
  static constexpr double kBehind = 6.0, kFinish = 4.0;

  PointerLead(WallHold::Part broad, WallHold::Part fine) : hold_(broad, fine) {}

  /// What the hands hold from the next time they are set down: as the constructor's.
  void take_up(WallHold::Part broad, WallHold::Part fine) { hold_ = WallHold(broad, fine); }
  /// `at`: x right of the axis, y height, metres (Camera::on_axis_plane).
  void grab(Vec2 at, const ClayView& clay, Grip grip);
  void drag(Vec2 at);
  /// A second pointer, as `at`, while the first is down: the one farther out draws the outside, and
  /// the wall between both hands follows the distance between the two, in proportion, from what it
  /// was when the second went down. Nothing: it has lifted.
  void pinch(std::optional<Vec2> at, const ClayView& clay);
  /// The pointer lifts.
  void release();
  /// Keys: begins half-way up at `sign` (+1 right of the axis, -1 left) when not yet working.
  void begin_by_keys(const ClayView& clay, Grip grip, double sign);
  /// Metres away from the axis (negative: towards it) and upwards.
  void move(double outward, double up);
  /// The hands come off the clay at once.
  void lift();
  /// Once a frame: `dt` seconds' way along what was drawn, and the hands keep to the wall as it now
  /// stands. `pressing`: they meet clay.
  void follow(const ClayView& clay, double dt, bool pressing);

  /// The hands work.
  bool active() const { return active_; }
  /// One of them works inside the pot.
  bool inside() const { return active_ && hands_.inside.there; }
  /// The pointer is down.
  bool grabbed() const { return grabbed_; }
  double height() const { return at_.height; }
  /// Where the worked face is to be by now, m from the axis.
  double reach() const { return pass_.reach(); }
  /// Seconds until the hands are where the pointer is.
  double behind() const;
  /// Hand 0 and hand 1. `right`: of the visitor who looks at the pot, level, unit, studio frame.
  std::array<HandInput, kMaxHands> input(Vec3 right) const;

 private:
  struct At {
    double reach = 0, height = 0;
  };
  void touch(const ClayView& clay, Grip grip, double height);
  bool come_out(const ClayView& clay, double dt);
  void go_along(double seconds, double press, double rise);
  At within(At at) const;

  WallHold hold_;
  WallPass pass_;
  WallHold::Hands hands_;
  std::deque<At> drawn_;  ///< And not yet followed.
  At at_;
  bool active_ = false, grabbed_ = false, finishing_ = false, easing_ = false;
  double upwards_ = 0;  ///< +1 where they last went up, -1 down, 0 nowhere yet.
  double sign_ = 1;
  double scrolled_ = 0;  ///< m, by which the wheel of a mouse set the reach off.
  double lowest_ = 0, highest_ = 1;
  std::optional<Vec2> first_, second_;  ///< Where the pointers are.
  double spread_ = 0, thick_ = 0;   ///< m between them, and the wall, when the second went down.
  double wall_ = 0;                 ///< m that it is to be; 0 as it is.
  double down_for_ = 0, left_ = 0;  ///< s since they were set down; until they must be done.
};

}  // namespace onggi::device
