#pragma once

#include <cstddef>
#include <optional>

#include "engine/script/ring_plan.h"
#include "kiosk/visit/screens/coil_hand.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/wheel_speed.h"

namespace onggi::screens {

/// The coil at a visitor's wheel: whether the pot is built of coils, whether its wall is there yet,
/// and the coil in the hand. `desk` outlives it. Main thread.
class CoilAtWheel {
 public:
  static constexpr std::size_t kTool = 1;  ///< Its index in the tray, where there is one.

  /// `two`: two visitors, who have no coil.
  CoilAtWheel(const Desk& desk, bool two) : desk_(desk), two_(two) {}

  /// The pot on the wheel is built of coils.
  bool built() const { return !two_ && desk_.wheel().coil; }
  double diameter() const { return built() ? *desk_.wheel().coil : 0.0; }  ///< m
  /// How its vessel is built; null if it is not, or there is no vessel to copy. Valid until the
  /// next call.
  const script::RingPlan* plan() const;
  /// It lacks clay by most of a ring: height or, where it will be beaten, clay.
  bool lacks_a_ring() const;
  /// Call once a frame. True when the last ring that was lacking has closed.
  bool wall_is_there_now();

  bool held() const { return hand_.has_value(); }
  CoilHand& hand() { return *hand_; }  ///< Only while held().
  bool active() const { return hand_ && hand_->active(); }
  bool grabbed() const { return hand_ && hand_->grabbed(); }
  bool by_itself() const { return hand_ && hand_->by_itself(); }
  void lift() {
    if (hand_) hand_->lift();
  }
  /// Takes it up or puts it away, and tells the wheel. With a coil the wheel is slow.
  void hold(bool on, WheelSpeed& speed);
  // The rest only while held().

  /// Call once a frame, of `dt` s.
  void follow(double dt);
  /// Lays one ring by itself where it belongs, at `side` (+1 right of the axis, -1 left).
  void lay_a_ring(double side) { hand_->lay_a_ring(side, desk_.world.wheel->clay); }
  /// Tells the wheel where the hand is.
  void send(const view::Camera& camera) const;
  /// `show`, as it is with a coil in the hand: it lays a ring.
  Button button(Button show) const;

 private:
  const Profile* target() const;

  const Desk& desk_;
  bool two_;
  std::optional<CoilHand> hand_;
  bool lacked_ = false;  ///< At the last frame.
  mutable std::optional<script::RingPlan> plan_;
  /// What it was made for.
  struct Planned {
    int card = -1;
    double height = 0, widest = 0, coil = 0;
    bool beats = false;
    friend bool operator==(const Planned&, const Planned&) = default;
  };
  mutable Planned planned_;
};

}  // namespace onggi::screens
