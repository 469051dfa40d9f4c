#pragma once

#include "engine/clay/clay_view.h"
#include "engine/math/vec.h"
#include "engine/scene/hands.h"

namespace onggi::device {

/// A finger, a mouse or arrow keys as the potter's hand, the screens' half: where the tool is to be
/// (PointerHand glides there). The tool stands in the plane through the
/// axis that faces the camera, on the side of the pot where the pointer went down. Going down sets
/// it so that it just touches the chosen face at the pointer's height; from there it moves as far
/// as the pointer does, millimetre for millimetre as seen.
class PointerLead {
 public:
  explicit PointerLead(double tool_radius) : tool_radius_(tool_radius) {}

  /// `at`: x right of the axis, y height, metres (Camera::on_axis_plane).
  void grab(Vec2 at, const ClayView& clay, WallSide face);
  void drag(Vec2 at);
  /// Keys: begins half-way up at `sign` (+1 right of the axis, -1 left) when not yet working.
  void begin_by_keys(const ClayView& clay, WallSide face, double sign);
  /// Metres away from the axis (negative: towards it) and upwards.
  void move(double outward, double up);
  void lift() { active_ = grabbed_ = false; }

  bool active() const { return active_; }
  bool grabbed() const { return grabbed_; }
  double height() const { return height_; }
  double radius() const { return radius_; }
  /// `right`: of the visitor who looks at the pot, level, unit, studio frame.
  HandInput input(Vec3 right) const;

 private:
  void touch(const ClayView& clay, WallSide face, double height);
  void clamp();

  double tool_radius_;
  bool active_ = false, grabbed_ = false;
  WallSide face_ = WallSide::outside;
  double sign_ = 1;
  double radius_ = 0, height_ = 0;  ///< Of the tool's centre.
  double grab_x_ = 0;               ///< Of the pointer when last seen.
  double lowest_ = 0, highest_ = 1;
};

}  // namespace onggi::device
