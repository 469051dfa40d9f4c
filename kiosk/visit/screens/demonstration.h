#pragma once

#include <optional>

#include "kiosk/visit/screens/visit.h"
#include "kiosk/visit/screens/wire_cut.h"
#include "kiosk/wheel/device/ghost_finger.h"
#include "kiosk/wheel/device/pointer_lead.h"
#include "kiosk/wheel/device/rib_pass.h"
#include "kiosk/wheel/device/trim_pass.h"
#include "kiosk/wheel/loop/wheel_commands.h"
#include "kiosk/wheel/loop/wheel_view.h"

namespace onggi::screens {

/// A potter throws a vessel for visitors to watch, with the same hands that they have. The potter
/// wets the clay, brings the wall to the outline stroke by stroke between both hands, trims the
/// foot, smooths it slowly, uses a rib, and cuts it off with the wire. Plans each stroke on the
/// current pot. Skips tools that the scene lacks. Main thread.
class Demonstration {
 public:
  /// Left-handed potters work on the left of the axis, and their wheel turns the other way.
  Demonstration(const SceneForVisitor& wheel, bool left_handed);

  /// Call once a frame while the pot is on the wheel. `right`: as in PointerLead::input.
  void update(double dt, const loop::WheelView& wheel, const Profile& target, Vec3 right,
              loop::WheelCommands& wheel_commands);
  /// Takes the hands off the clay and the sponge away. The next update() continues.
  void let_go(loop::WheelCommands& wheel_commands);
  bool done() const { return stage_ == Stage::done; }

 private:
  enum class Stage : std::uint8_t { wet, throwing, foot, even, rib, stand, wire, done };
  void enter(Stage stage) { stage_ = stage, stage_time_ = 0; }
  void send(Vec3 right, loop::WheelCommands& wheel_commands) const;
  bool rested(double dt, double seconds);
  void turn(double speed, loop::WheelCommands& wheel_commands);
  void take_hands(const Profile& target);
  void next_stage(const loop::WheelView& wheel, const Profile& target);
  void throw_on(double dt, const loop::WheelView& wheel, const Profile& target,
                loop::WheelCommands& wheel_commands);

  SceneForVisitor wheel_;
  device::PointerLead hands_;
  device::GhostFinger finger_;
  std::optional<device::RibPass> rib_;
  std::optional<device::TrimPass> trimmer_;
  std::optional<WireCut> wire_;
  Profile worked_;  ///< The target as the hands can make it.
  double side_;     ///< +1 right of the axis, -1 left.
  Stage stage_ = Stage::wet;
  double wheel_time_ = 0;       ///< The wheel's own, s, at the last update.
  double stage_time_ = 0;       ///< s in this stage, or since the last stroke.
  double requested_speed_ = 0;  ///< rad/s, the last requested wheel speed.
  int strokes_ = 0;
  bool water_ = false;
};

}  // namespace onggi::screens
