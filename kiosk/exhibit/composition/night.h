#pragma once

#include <optional>
#include <utility>

#include "kiosk/collection/settings/hours.h"
#include "kiosk/ground/files/local_time.h"

namespace onggi::exhibit {

/// Decides when the kiosk is dark: outside the museum's hours, when nobody is here. The wall clock
/// may jump: it is read again each time, and waits use a clock that never goes back. If the wall
/// clock is years off, the kiosk stays open.
class Night {
 public:
  /// Outside the hours a touch wakes the screen for this long, s: cleaners see what it is, and a
  /// museum with a wrong clock still has a kiosk.
  static constexpr double kAwake = 300.0;

  explicit Night(settings::Hours hours) : hours_(std::move(hours)) {}

  /// Call once a frame; `now` in s on a clock that never goes back. `nobody`: there is no visit.
  /// `touched`: somebody touched something since the last call. True if it is dark from now on.
  bool look(double now, const files::LocalMoment& wall, bool nobody, bool touched);
  bool dark() const { return dark_; }

 private:
  settings::Hours hours_;
  std::optional<double> touched_at_;
  bool dark_ = false;
};

}  // namespace onggi::exhibit
