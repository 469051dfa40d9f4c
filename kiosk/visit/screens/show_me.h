#pragma once

#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/wheel/device/ghost_finger.h"
#include "kiosk/wheel/device/pointer_lead.h"

namespace onggi::screens {

/// "Show me": makes the next stroke on the visitor's own pot with the visitor's two hands. The
/// stroke is recorded and can be undone like any other. It runs to its end unless the button is
/// pressed again or the pot is touched.
class ShowMe {
 public:
  static constexpr double kHold = 0.6;  ///< s: after a longer press, it ends on release.

  /// The button goes down: starts or ends the stroke.
  void hold(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);
  /// The button was released, or pressed by a key.
  void press(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);
  /// Call once a frame, before PointerLead::follow.
  void draw(double dt, device::PointerLead& hands, const ClayView& clay);
  /// Starts a stroke that was asked for by name, instead of the current one.
  void make(device::Stroke stroke, const ClayView& clay, double side, device::PointerLead& hands);
  /// The visitor takes over.
  void stop(device::PointerLead& hands);

  /// The button's state. `away`: nothing can be shown.
  Button button(const Desk& desk, bool away) const;
  bool showing() const { return finger_.down(); }
  /// Language key of the current stroke: "show.open", "show.belly", "show.collar", "show.smooth".
  std::string key() const;
  content::HandsDrawn drawing() const;
  static constexpr const char* kKeys[] = {"show.open", "show.belly", "show.collar", "show.smooth"};

 private:
  void begin(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);

  device::GhostFinger finger_;
  double held_since_ = -1;  ///< s, by the desk's clock; negative: the button is up.
  bool asked_ = false;      ///< The current stroke was asked for by name.
  bool ended_ = false;      ///< The press ended a stroke.
};

}  // namespace onggi::screens
