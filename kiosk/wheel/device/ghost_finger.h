#pragma once

#include <optional>

#include "kiosk/wheel/device/pointer_lead.h"
#include "kiosk/wheel/device/stroke_plan.h"

namespace onggi::device {

/// Draws a stroke for PointerLead as a visitor's finger would, so that demonstrations use the same
/// way as visitors. Main thread.
class GhostFinger {
 public:
  static constexpr double kRest = 0.35;  ///< s of rest on the clay before and after the stroke.

  /// Touches the start of the stroke, at `sign` (+1 right of the axis, -1 left) of the pot.
  void begin(Stroke stroke, double sign, PointerLead& hands, const ClayView& clay);
  /// Once a frame, before PointerLead::follow: draws on. Lifts at the end of the stroke.
  void draw(double dt, PointerLead& hands, const ClayView& clay);
  /// Lifts here; the hands leave the clay at once.
  void stop(PointerLead& hands);

  bool down() const { return stroke_.has_value(); }
  /// The current stroke; nothing while the finger is up.
  const std::optional<Stroke>& stroke() const { return stroke_; }

 private:
  void drag(PointerLead& hands, const ClayView& clay);

  std::optional<Stroke> stroke_;
  double sign_ = 1, waits_ = 0;
  std::size_t next_ = 0;  ///< Next point of the path.
  Vec2 at_;
};

}  // namespace onggi::device
