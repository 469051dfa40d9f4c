#pragma once

#include <optional>

#include "kiosk/visit/decorating/decorated_pot.h"

namespace onggi::decorating {

/// "Show me": the held tool draws once by itself on the visitor's own pot, and what it drew is
/// taken back. It lasts 3 to 6 s. Main thread. Knows no screen and no clock.
class Example {
 public:
  static constexpr double kLongest = 6.0;  ///< s

  /// Begins with the tool that `pot` holds, unless that waits for another one.
  void begin(DecoratedPot& pot);
  /// Takes back what was drawn, at once. Does nothing where none is shown.
  void stop(DecoratedPot& pot);
  bool shows() const { return since_ >= 0.0; }
  /// Once a frame, before DecoratedPot::update. `front`: where the pot faces the eye, turns.
  void step(double dt, double front, DecoratedPot& pot);
  /// True while the pot should hurry, so that the end is seen.
  bool hurries() const { return since_ > kHurriesFrom; }

  /// The finger that leads the tool.
  struct Finger {
    Place at;
    double off = 0.0;  ///< How far it is from the clay: 0 touches .. 1.
  };
  /// Absent once it has left.
  const std::optional<Finger>& finger() const { return finger_; }

 private:
  static constexpr double kHurriesFrom = 3.6;  ///< s
  Place place(double share, double front, const DecoratedPot& pot) const;

  double since_ = -1.0, stands_since_ = -1.0;  ///< s
  bool down_ = false, lifted_ = false;
  std::optional<Finger> finger_;
};

}  // namespace onggi::decorating
