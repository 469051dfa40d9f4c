#pragma once

#include <optional>

#include "engine/clay/clay_view.h"
#include "kiosk/picture/view/camera.h"
#include "kiosk/picture/view/input.h"

namespace onggi::screens {

/// A finger that turns the wheel by its head, in front of the pot, as a potter does by hand or
/// foot. Nothing happens before it has gone some way round, so a tap does not brake the wheel; and
/// a finger that goes up onto the pot instead works there. Main thread.
class WheelPush {
 public:
  enum class Takes {
    nothing,  ///< The event is not for the wheel.
    wheel,    ///< The finger is on the wheel head.
    lets_go,  ///< It has gone up onto the pot: from here on it is another's.
  };
  /// A finger or the mouse. `radius` of the wheel head, m. What lies under `clay` in the picture is
  /// the clay's.
  Takes pointer(const view::InputEvent& event, const view::Camera& camera, double radius,
                const ClayView& clay);
  /// Call once a frame, of `dt` s. How fast the finger turns the wheel, rad/s, from x towards z;
  /// nothing while it does not.
  std::optional<double> speed(double dt);
  void lift() { down_ = turns_ = false; }

 private:
  std::optional<double> angle_of(float x, float y, const view::Camera& camera) const;

  bool down_ = false, turns_ = false;
  double angle_ = 0;   ///< Of the finger about the axis, rad.
  double turned_ = 0;  ///< Since it went down, or since the last frame if it turns the wheel.
  double speed_ = 0;   ///< rad/s, smoothed.
  double still_ = 0;   ///< s since it moved.
};

}  // namespace onggi::screens
