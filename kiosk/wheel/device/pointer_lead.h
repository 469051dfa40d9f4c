#pragma once

#include <array>
#include <deque>
#include <optional>

#include "engine/math/vec.h"
#include "engine/scene/hands.h"
#include "kiosk/wheel/device/wall_hold.h"
#include "kiosk/wheel/device/wall_pass.h"

namespace onggi::device {

/// The screens' side of a finger, a mouse or arrow keys as the potter's hands: it sets the tools'
/// targets (PointerHand glides there). The hands are in the plane through the axis that faces the
/// camera, on the side of the pot where the pointer is. When the pointer goes down, the
/// hands just touch the clay at its height. Then they follow the drawn line at a potter's pace,
/// including corners: the face they work moves to the line, as far as one pass allows (WallPass).
/// When the pointer lifts, they finish the line and go on a little as they come out of the clay.
///
/// A pointer that goes down below the foot, or in front of the pot, is on its way: the hands only
/// touch the wall. They begin to work when the pointer, above the foot, comes out to the face, goes
/// up or down along the wall, rests, or lifts farther in. So a stroke from the wheel's head out to
/// the line opens the pot and never digs into it first. What counts is the pointer's distance from
/// the axis, on either side; a pointer that crosses the axis has the hands cross with it. Main
/// thread.
class PointerLead {
 public:
  /// m/s along the wall and towards the axis or away, in clay and in the air. A pointer crosses the
  /// pot in a tenth of a second; hands that fast would cut a screw thread.
  static constexpr double kRise = 0.05, kPress = 0.05, kAir = 0.35;
  /// m/s into the solid foot, where a hand only moves towards the pointer.
  static constexpr double kSolid = 0.01;
  /// s that the hands may lag before they hurry, and s that they continue after the pointer lifts.
  static constexpr double kBehind = 6.0, kFinish = 4.0;
  /// m inside the outline from which a pointer is on its way. One that is nearer means the wall.
  static constexpr double kInFront = 0.02;
  /// Rise over run of a stroke along the wall, over so many m; and s of rest that mean "press
  /// here".
  static constexpr double kSteep = 3, kHeading = 0.008, kRest = 0.3;
  /// s that the hands are off the clay while they change sides.
  static constexpr double kAcross = 0.05;

  PointerLead(WallHold::Part broad, WallHold::Part fine) : hold_(broad, fine) {}

  /// Sets the hands' parts from the next touch on, like the constructor.
  void take_up(WallHold::Part broad, WallHold::Part fine) { hold_ = WallHold(broad, fine); }
  /// `at`: x right of the axis, y height, metres (Camera::on_axis_plane).
  void grab(Vec2 at, const ClayView& clay, Grip grip);
  void drag(Vec2 at);
  /// A second pointer, like `at`, while the first is down. The outer of the two draws the outside.
  /// The wall between both hands follows the distance between the pointers, relative to the
  /// distance when the second went down. Without a value: the second pointer was lifted.
  void pinch(std::optional<Vec2> at, const ClayView& clay);
  void release();
  /// Keys: begins at half height at `sign` (+1 right of the axis, -1 left), unless already working.
  void begin_by_keys(const ClayView& clay, Grip grip, double sign);
  /// Metres away from the axis (negative: towards it) and upwards.
  void move(double outward, double up);
  /// The hands come off the clay at once.
  void lift();
  /// Once a frame: moves `dt` seconds along the drawn line, and keeps the hands at the wall as it
  /// is now. `pressing`: they touch clay.
  void follow(const ClayView& clay, double dt, bool pressing);

  /// True while the hands work.
  bool active() const { return active_; }
  /// True if a hand works inside the pot.
  bool inside() const { return active_ && hands_.inside.there; }
  bool grabbed() const { return grabbed_; }
  double height() const { return at_.height; }
  /// Wanted radius of the worked face now, m from the axis.
  double reach() const { return pass_.reach(); }
  /// Seconds until the hands reach the pointer.
  double behind() const;
  /// Hand 0 and hand 1. `right`: the right of the visitor who looks at the pot, level, unit length,
  /// studio frame.
  std::array<HandInput, kMaxHands> input(Vec3 right) const;

 private:
  struct At {
    double reach = 0, height = 0;
    bool light = false;  ///< The hands only touch: the reach is the wall's own.
  };
  void touch(const ClayView& clay, Grip grip, double height);
  bool come_out(const ClayView& clay, double dt);
  void go_along(double seconds, double press, double rise);
  bool on_its_way(Vec2 at);
  At within(At at) const;

  WallHold hold_;
  WallPass pass_;
  WallHold::Hands hands_;
  std::deque<At> drawn_;  ///< The drawn points that are not followed yet.
  At at_;
  bool active_ = false, grabbed_ = false, finishing_ = false, easing_ = false;
  std::optional<Vec2> began_;  ///< Where the pointer went down, while it is on its way to the wall.
  Vec2 heads_;                 ///< Where it last was kHeading ago.
  double rests_ = 0;           ///< s since it moved.
  double upwards_ = 0;         ///< +1 if they last went up, -1 down, 0 not known yet.
  double sign_ = 1;
  double across_ = 0;    ///< s until they are on the other side.
  double scrolled_ = 0;  ///< m by which a mouse's wheel shifted the reach.
  double lowest_ = 0, highest_ = 1;
  std::optional<Vec2> first_, second_;  ///< The pointers.
  /// M between them, and the wall's thickness, when the second went down.
  double spread_ = 0, thick_ = 0;
  double wall_ = 0;                 ///< Wanted thickness of the wall, m; 0: unchanged.
  double down_for_ = 0, left_ = 0;  ///< s since they were set down; s until they must be done.
};

}  // namespace onggi::device
