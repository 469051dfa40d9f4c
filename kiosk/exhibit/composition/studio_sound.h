#pragma once

#include "kiosk/visit/screens/visit.h"
#include "kiosk/visit/sound/speaker.h"
#include "kiosk/wheel/loop/potter_host.h"

namespace onggi::exhibit {

/// What an open exhibit sounds like: the wheel and the hands of the visitor who works on it, and
/// the kiln while its screen is shown. Silent in attract, for a visitor who chose so, in the dark,
/// and where there is no sound card, which it says once in the log. Main thread; SDL's thread reads
/// the wheel's status.
class StudioSound {
 public:
  /// `potter`, which stays longer than this, is listened to; `volume` 0..1.
  StudioSound(const loop::PotterHost& potter, double volume);
  /// Once a frame, `now` in s on a clock that never goes back; `visit` may be null.
  void frame(double now, const screens::Visit* visit, bool dark);
  /// The widths of vessel and pot as pitch, from the foot to the rim.
  void sing(const screens::Sight& sight);
  const sound::Speaker& speaker() const { return speaker_; }

 private:
  double volume_;
  sound::Speaker speaker_;
};

}  // namespace onggi::exhibit
