#pragma once

#include <optional>
#include <string_view>

#include "kiosk/visit/screens/coil_at_wheel.h"
#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/hint.h"
#include "kiosk/visit/screens/paddle_hand.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/wheel_speed.h"

namespace onggi::screens {

/// What a visitor at the wheel may hold in place of hands and tools: a coil of clay, or a paddle
/// with its anvil. One of them at most. `desk` outlives it. Main thread.
class InsteadOfHands {
 public:
  /// `two`: two visitors, who have neither.
  InsteadOfHands(const Desk& desk, bool two) : desk_(desk), two_(two), coil_(desk, two) {}

  CoilAtWheel& coil() { return coil_; }
  const CoilAtWheel& coil() const { return coil_; }
  bool paddle() const { return paddle_.has_value(); }
  /// The index of the paddle in the tray; only where has(scene::kPaddle).
  std::size_t paddles_place() const { return coil_.built() ? CoilAtWheel::kTool + 1 : 1; }
  /// All rings are laid, and the wall is not yet thin and on the vessel's line.
  bool to_beat() const;
  /// For the hints; nothing if the pot is not built of coils.
  std::optional<BuiltPot> state() const;

  /// The tray's `tool` is one of them. False for two visitors.
  bool has(std::string_view tool) const;
  /// Takes up the tray's `tool`, if it is one of them; puts away what was held.
  void take_up(std::string_view tool, WheelSpeed& speed);

  bool held() const { return coil_.held() || paddle_; }
  bool active() const { return coil_.active() || (paddle_ && paddle_->active()); }
  bool grabbed() const { return coil_.grabbed() || (paddle_ && paddle_->grabbed()); }
  bool by_itself() const { return coil_.by_itself() || (paddle_ && paddle_->by_itself()); }
  void lift();
  /// Call once a frame: a paddle strikes so that the wall comes to the vessel's line, whatever hand
  /// leads it.
  void aim();
  // The rest only while held().

  /// A finger or the mouse. True if the hand must be sent to the wheel.
  bool pointer(const view::InputEvent& event, const view::Camera& camera);
  /// Sets it down at `side` (+1 right of the axis, -1 left), or moves it, m.
  void move_by_keys(double side, double outward, double up);
  /// Call once a frame, of `dt` s.
  void follow(double dt);
  /// Tells the wheel where the hand is.
  void send(const view::Camera& camera) const;
  /// Lays a ring, or beats the wall once from the foot to the rim.
  void work_by_itself(double side);
  /// `show`, as it is now: it begins and ends work_by_itself().
  Button button(Button show) const;

 private:
  /// Of the wall at `height` (m), as a share of dry clay's.
  double strength_at(double height) const;

  const Desk& desk_;
  bool two_;
  CoilAtWheel coil_;
  std::optional<PaddleHand> paddle_;
  script::Swings aimed_;  ///< What the wheel was told last.
  std::optional<script::RingPlan::Worst> worst_;
};

}  // namespace onggi::screens
