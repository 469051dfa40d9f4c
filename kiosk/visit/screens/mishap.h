#pragma once

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// What went wrong with the clay, as the visitor is told: a pot that fell, or a wall that tore. A
/// fall goes before a tear.
enum class Mishap { none, fell, tore_thin, tore_wide };

/// Watches the pot on the wheel for a mishap, and leads back to before it.
class MishapWatch {
 public:
  /// Once a frame. True when what is to be told has changed.
  bool update(Desk& desk);
  Mishap now() const { return now_; }
  explicit operator bool() const { return now_ != Mishap::none; }
  /// Asks for the last step back; after a tear for as many as it takes until the wall is whole.
  void go_back(Desk& desk);
  /// The visitor goes on from here.
  void stay() { going_back_ = false; }

 private:
  Mishap seen(const Desk& desk) const;

  Mishap now_ = Mishap::none;
  bool going_back_ = false;
  double asked_at_ = 0;  // s of the scene
};

}  // namespace onggi::screens
