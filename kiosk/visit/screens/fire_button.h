#pragma once

#include <cmath>
#include <utility>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// A pot of charcoal that hangs in a pot which is built of coils: a switch, in the place of water.
/// It is taken out by itself once the clay is dry. Main thread.
class FireButton {
 public:
  static constexpr double kReady = 0.12;  ///< Wetness: drier clay rings under a blow.

  bool hangs() const { return hangs_; }
  void hang(bool on, const Desk& desk) {
    if (std::exchange(hangs_, on) != on) desk.world.wheel_commands->fire(on);
  }
  void press(const Desk& desk) { hang(!hangs_, desk); }
  /// A new pot has none.
  void gone() { hangs_ = false; }
  /// Call once a frame, of `dt` s.
  void look(const Desk& desk, double dt) {
    if (hangs_ && desk.status.feedback.wetness < kDry) hang(false, desk);
    const double to = hangs_ ? 1.0 : 0.0;
    glow_ = desk.still() ? to : to + (glow_ - to) * std::exp(-dt / kGlows);
  }
  /// How bright it is, 0..1.
  double glow() const { return glow_ < 0.004 ? 0.0 : glow_; }
  /// Blows would sound dull.
  static bool wet(const Desk& desk) { return desk.status.feedback.wetness >= kReady; }

 private:
  static constexpr double kDry = 0.02;   // of wetness
  static constexpr double kGlows = 0.4;  // s
  bool hangs_ = false;
  double glow_ = 0;
};

}  // namespace onggi::screens
