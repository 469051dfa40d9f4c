#pragma once

#include <optional>

#include "engine/clay/clay_view.h"
#include "engine/scene/hands.h"
#include "kiosk/picture/view/camera.h"
#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// The hand of a visitor who beats the wall with a paddle. It is where the finger is on the pot as
/// the picture shows it, just off the wall, and strikes there again and again (loop::Paddle) while
/// the wheel turns. Main thread.
class PaddleHand {
 public:
  /// `face`: radius of the paddle's face; `ball`: radius of the hand's ball, m.
  PaddleHand(double face, double ball) : face_(face), ball_(ball) {}

  /// A finger or the mouse. True if the hand must be sent to the wheel.
  bool pointer(const view::InputEvent& event);
  /// Keys: sets the hand down at `side` (+1 right of the axis, -1 left), or moves it by `up`, m.
  void move_by_keys(double side, double up, const ClayView& clay);
  /// Beats by itself, from the foot to the rim at `side`, in `seconds`. One that was stopped on the
  /// way goes on from there.
  void beat_up(double side, double seconds);
  /// Call once a frame, of `dt` s. Lifts the hand when beat_up() is done.
  void follow(double dt);
  void lift() { active_ = grabbed_ = false, left_.reset(); }

  bool active() const { return active_; }
  bool grabbed() const { return grabbed_; }
  bool by_itself() const { return left_.has_value(); }
  /// Not active where the finger is off the pot.
  HandInput input(const view::Camera& camera, const ClayView& clay) const;

 private:
  double lowest(const ClayView& clay) const;
  double highest(const ClayView& clay) const;

  double face_, ball_;
  bool active_ = false, grabbed_ = false;
  float px_ = 0, py_ = 0;       ///< Pixels, of a finger.
  double side_ = 1, up_ = 0;    ///< Of keys: m above the wheel head.
  std::optional<double> left_;  ///< s of beat_up() to go,
  double whole_ = 1;            ///< of so many,
  double stopped_ = 0;          ///< and the s that were left when it was stopped; 0: it was not.
};

}  // namespace onggi::screens
