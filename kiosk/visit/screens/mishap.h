#pragma once

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// A fault of the clay to tell the visitor about: a pot that fell, or a wall that tore. A fall has
/// priority over a tear.
enum class Mishap { none, fell, tore_thin, tore_wide };

/// Watches the pot on the wheel for a mishap, and undoes it on request.
class MishapWatch {
 public:
  /// Call once a frame. True if the message has changed.
  bool update(Desk& desk);
  Mishap now() const { return now_; }
  explicit operator bool() const { return now_ != Mishap::none; }
  /// Requests one undo; after a tear, as many as it takes until the wall is whole.
  void go_back(Desk& desk);
  /// Call when the visitor continues without undoing.
  void stay() { going_back_ = false; }

 private:
  Mishap seen(const Desk& desk) const;

  Mishap now_ = Mishap::none;
  bool going_back_ = false;
  double asked_at_ = 0;  // s, the scene's time
};

}  // namespace onggi::screens
