#pragma once

#include <cstdint>

#include "kiosk/visit/screens/desk.h"

namespace onggi::screens {

/// The exhibit's lesson as one visitor is led through it: a step is shown until the visitor has
/// done it or its time is up. What was done before its step came is not asked for. Where the
/// visitor stands in it is the desk's, so that no step comes twice however often the wheel is left.
class LessonLine {
 public:
  /// Once a frame with the pot on the wheel. `alone`: the hands are the visitor's own.
  void update(Desk& desk, double dt, const Profile* target, const Profile& made, bool alone);
  /// The step to be shown now; null where there is none, or none any more.
  static const content::LessonStep* shown(const Desk& desk);
  /// The visitor wants none of it.
  static void skip(Desk& desk);

 private:
  void watch(const Desk& desk, double dt, const Profile* target, const Profile& made);
  bool has(content::DoneWhen what) const {
    return (done_ >> static_cast<unsigned>(what) & 1u) != 0;
  }
  void note(content::DoneWhen what) { done_ |= 1u << static_cast<unsigned>(what); }

  std::uint32_t done_ = 0;                        ///< Bits by DoneWhen, of this stay at the wheel.
  double touched_ = 0, inside_ = 0, at_rim_ = 0;  ///< s so far.
  double lowest_ = -1;  ///< Where the stroke under way began to rise, m; below 0: none is.
  double apart_ = 0;    ///< s since the clay was last met.
  double in_step_ = 0;  ///< s that the step has been shown.
  double looked_ = 0;   ///< s since the outline was looked at.
};

}  // namespace onggi::screens
