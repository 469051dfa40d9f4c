#pragma once

#include "kiosk/visit/screens/visit.h"
#include "kiosk/visit/sound/speaker.h"
#include "kiosk/wheel/loop/wheel_host.h"

namespace onggi::exhibit {

/// The sound of an open exhibit: the wheel, the hands of the visitor, and the kiln on its screen.
/// Silent in attract, for a visitor who turned sound off, in the dark, and without a sound card,
/// which is logged once. Main thread; SDL's thread reads the wheel's status.
class StudioSound {
 public:
  /// Reads `wheel_host`, which must outlive this; `volume` 0..1.
  StudioSound(const loop::WheelHost& wheel_host, double volume);
  /// Call once a frame, `now` in s on a clock that never goes back; `visit` may be null.
  void frame(double now, const screens::Visit* visit, bool dark);
  /// Plays the widths of vessel and pot as pitch, from the foot to the rim.
  void sing(const screens::WheelSnapshot& sight);
  const sound::Speaker& speaker() const { return speaker_; }

 private:
  double volume_;
  sound::Speaker speaker_;
};

}  // namespace onggi::exhibit
