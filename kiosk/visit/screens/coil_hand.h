#pragma once

#include <optional>

#include "engine/clay/clay_view.h"
#include "engine/scene/hands.h"
#include "kiosk/picture/view/camera.h"
#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// The hand of a visitor who holds a coil of clay. It stays on the rim, whatever its height, so a
/// finger that holds still lays ring on ring while the wheel turns. The coil comes to lie where the
/// vessel wants it; sideways the finger moves it by up to half a coil, and so widens or closes the
/// pot. A finger that goes across the pot goes round it: then the coil is where the finger is on
/// the rim. Main thread.
class CoilHand {
 public:
  /// `diameter` of the coil, m.
  explicit CoilHand(double diameter) : diameter_(diameter) {}

  /// A finger or the mouse. True if the hand must be sent to the wheel.
  bool pointer(const view::InputEvent& event, const view::Camera& camera, const ClayView& clay);
  /// Keys: sets the hand down at `side` (+1 right of the axis, -1 left), or moves it by `outward`,
  /// m.
  void move_by_keys(double side, double outward);
  /// Lays one ring by itself at `side`.
  void lay_a_ring(double side, const ClayView& clay);
  /// Call once a frame, of `dt` s. `belongs`: where the ring belongs, m from the axis, as far as
  /// the wall allows; nothing: on the middle of the rim. Lifts the hand when the ring of
  /// lay_a_ring() is closed.
  void follow(const ClayView& clay, double dt, std::optional<double> belongs);
  void lift() { active_ = grabbed_ = false, wish_ = aside_ = 0, ends_.reset(); }

  bool active() const { return active_; }
  bool grabbed() const { return grabbed_; }
  bool by_itself() const { return ends_.has_value(); }
  HandInput input(const view::Camera& camera, const ClayView& clay) const;

  /// Middle of the wall's top, where a coil lies without a lean, m from the axis.
  static double middle_of_rim(const ClayView& clay, double diameter);

 private:
  double diameter_;
  bool active_ = false, grabbed_ = false;
  bool round_ = false;     ///< The finger goes round the pot.
  double began_ = 0;       ///< m right of the axis, where it went down.
  float px_ = 0, py_ = 0;  ///< Pixels.
  double side_ = 1;
  std::optional<double> belongs_;  ///< m from the axis.
  double wish_ = 0, aside_ = 0;    ///< m from there: where the finger wants the coil, and it is.
  double rim_ = 0,
         lightly_ = 0;          ///< Height of the rim at the last frame, m; s to lie on it lightly.
  std::optional<double> ends_;  ///< Height of the rim above which the ring is closed, m.
};

}  // namespace onggi::screens
