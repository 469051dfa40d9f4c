#pragma once

#include <optional>
#include <utility>

#include "kiosk/collection/settings/hours.h"
#include "kiosk/ground/files/local_time.h"

namespace onggi::exhibit {

/// When the kiosk is dark: outside of the museum's hours, once nobody is here. The clock on the
/// wall may jump as it will: it is asked anew each time, and waits are on a clock that never goes
/// back. One that is years off tells nothing, and then the kiosk is open.
class Night {
 public:
  /// Out of hours a touch wakes for so long, s: whoever cleans sees what it is, and a museum whose
  /// clock is wrong still has a kiosk.
  static constexpr double kAwake = 300.0;

  explicit Night(settings::Hours hours) : hours_(std::move(hours)) {}

  /// Once a frame; `now` in s on the clock that never goes back. `nobody`: no visit is under way.
  /// `touched`: somebody touched something since the last call. True when it is dark from now on.
  bool look(double now, const files::LocalMoment& wall, bool nobody, bool touched);
  bool dark() const { return dark_; }

 private:
  settings::Hours hours_;
  std::optional<double> touched_at_;
  bool dark_ = false;
};

}  // namespace onggi::exhibit
