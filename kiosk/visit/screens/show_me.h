#pragma once

#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/wheel/device/ghost_finger.h"
#include "kiosk/wheel/device/pointer_lead.h"

namespace onggi::screens {

/// "Show me": the next stroke on the visitor's own pot, by the visitor's own two hands, led by
/// nobody's finger. It is a stroke like any other: recorded, and taken back like any. It goes on to
/// its end unless it is pressed again, or the pot is touched.
class ShowMe {
 public:
  static constexpr double kHold = 0.6;  ///< s: pressed longer, it ends when it is let go.

  /// The button goes down: the stroke begins, or ends.
  void hold(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);
  /// The button comes up, or was pressed by a key.
  void press(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);
  /// Once a frame, before PointerLead::follow.
  void draw(double dt, device::PointerLead& hands, const ClayView& clay);
  /// A stroke that was asked for by name begins, instead of the one under way.
  void make(device::Stroke stroke, const ClayView& clay, double side, device::PointerLead& hands);
  /// The visitor takes over.
  void stop(device::PointerLead& hands);

  /// As it stands now; `away`: nothing can be shown.
  Button button(const Desk& desk, bool away) const;
  bool showing() const { return finger_.down(); }
  /// Of the stroke under way: "show.open", "show.belly", "show.collar", "show.smooth".
  std::string key() const;
  content::HandsDrawn drawing() const;
  static constexpr const char* kKeys[] = {"show.open", "show.belly", "show.collar", "show.smooth"};

 private:
  void begin(const Desk& desk, const Profile& target, double side, device::PointerLead& hands);

  device::GhostFinger finger_;
  double held_since_ = -1;  ///< s, by the desk's clock; below 0: the button is up.
  bool asked_ = false;      ///< The stroke under way was asked for by name.
  bool ended_ = false;      ///< It was pressed to end a stroke.
};

}  // namespace onggi::screens
