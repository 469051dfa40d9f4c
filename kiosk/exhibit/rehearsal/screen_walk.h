#pragma once

#include <functional>
#include <string>

#include "kiosk/exhibit/composition/kiosk.h"

namespace onggi::rehearsal {

/// Walks through the screens of a stepped kiosk by its controls, faster than real time and without
/// drawing. After a failure every step does nothing. Main thread.
class ScreenWalk {
 public:
  static constexpr double kSettled = 1.5;  ///< s: cross-fades and easing are over.

  /// `kiosk`: newly opened, and the caller's.
  explicit ScreenWalk(exhibit::Kiosk& kiosk) : kiosk_(kiosk) {}

  bool good() const { return good_.has_value(); }
  Result<void> result() const { return good_; }
  /// Ends the walk with this failure, if there is none yet.
  void fail(const Result<void>& why) {
    if (good() && !why) good_ = why;
  }

  void frames(double seconds);
  /// Goes on until `done()`; fails, naming `what`, if that takes 400 s of visit. `here`: somebody
  /// is seen to be there.
  void until(const char* what, const std::function<bool()>& done, bool here = true);
  /// Touches `control`, behind a drawer too. Fails if there is none.
  void touch(const std::string& control);
  /// Touches the pot of attract.
  void touch_clay();
  bool has(const std::string& control) const { return kiosk_.visit().control(control).has_value(); }
  /// Turns the shelf's pages until `control` is on one.
  void turn_to(const std::string& control);
  /// The hands of a script throw the pot on the wheel until so much of it is done, 0 to 1.
  void throw_pot(double part);

 private:
  void frame();
  void miss(const std::string& what);

  exhibit::Kiosk& kiosk_;
  Result<void> good_;
  double now_ = 0;
};

}  // namespace onggi::rehearsal
