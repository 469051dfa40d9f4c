#pragma once

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// Whether the pot on the wheel is a visitor's work: a hand has been at it, and that was not all
/// undone. Fresh clay is nobody's. Keeps Desk::touched.
class TouchedClay {
 public:
  /// Call once a frame. `contact`: a hand presses the clay.
  void look(Desk& desk, bool contact);
  void renewed(Desk& desk);  ///< A fresh lump was asked for.
  void undone(Desk& desk);   ///< The last step was taken back.
  /// True if there is something to call done. Else the visitor is asked for it for some seconds.
  bool comes_first(const Desk& desk);
  bool asked_for(const Desk& desk) const { return desk.now < asked_until_; }

 private:
  bool renewed_ = false;  ///< Undo brings a touched pot back.
  bool undoes_ = false;   ///< The last thing that happened to the pot was an undo.
  double asked_until_ = -1;
};

}  // namespace onggi::screens
