#pragma once

#include <optional>

#include "kiosk/wheel/device/pointer_lead.h"
#include "kiosk/wheel/device/stroke_plan.h"

namespace onggi::device {

/// Draws a stroke for PointerLead as a visitor's finger would, so that hands which show something
/// do what a visitor's hands can do, by the same way. Main thread.
class GhostFinger {
 public:
  static constexpr double kRest = 0.35;  ///< s on the clay before it goes and after it came.

  /// Goes down where the stroke begins, at `sign` (+1 right of the axis, -1 left) of the pot.
  void begin(Stroke stroke, double sign, PointerLead& hands, const ClayView& clay);
  /// Once a frame, before PointerLead::follow: draws on. Lifts at the stroke's end.
  void draw(double dt, PointerLead& hands, const ClayView& clay);
  /// Lifts where it is; the hands come off at once.
  void stop(PointerLead& hands);

  bool down() const { return stroke_.has_value(); }
  /// What it draws; nothing while it is up.
  const std::optional<Stroke>& stroke() const { return stroke_; }

 private:
  void drag(PointerLead& hands, const ClayView& clay);

  std::optional<Stroke> stroke_;
  double sign_ = 1, waits_ = 0;
  std::size_t next_ = 0;  ///< Of the path.
  Vec2 at_;
};

}  // namespace onggi::device
