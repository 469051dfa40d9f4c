#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/visit/screens/hint.h"

namespace onggi::screens {

/// Leads one visitor through the exhibit's lesson: a step is shown until the visitor has done it,
/// or its time is up and the hands rest. A step that was done earlier is skipped, and so is one
/// that the line denies. The desk keeps the position, so that no step comes twice when the visitor
/// leaves the wheel and returns to the same pot.
class LessonLine {
 public:
  /// Call once a frame with the pot on the wheel. `alone`: the visitor's own hands work. `built`:
  /// of a pot that is built of coils.
  void update(Desk& desk, double dt, const Profile* target, const Profile& made, bool alone,
              const std::optional<BuiltPot>& built);
  /// The step to show now; null if there is none or the lesson is over.
  static const content::LessonStep* shown(const Desk& desk);
  static void skip(Desk& desk);
  /// The lesson is over, or asks to end the pot.
  static bool leaves_off(const Desk& desk);
  /// What the arrow keys do for a step, in the desk's language.
  static std::string by_keys(const Desk& desk, content::DoneWhen until);

 private:
  /// Forgets what was done at other clay.
  void begin(const Profile& made);
  static_assert(content::kDoneWhen.size() <= 32);
  void watch_built(const Desk& desk, const BuiltPot& built, const Profile& made);
  void watch(const Desk& desk, double dt, const Profile* target, const Profile& made);
  bool has(content::DoneWhen what) const {
    return (done_ >> static_cast<unsigned>(what) & 1u) != 0;
  }
  void note(content::DoneWhen what, bool done = true) {
    const std::uint32_t bit = 1u << static_cast<unsigned>(what);
    done_ = done ? done_ | bit : done_ & ~bit;
  }

  std::uint32_t done_ = 0;            ///< Bits by DoneWhen, since the visitor came to this clay.
  Profile began_with_;                ///< The clay then.
  double touched_ = 0, at_rim_ = 0;   ///< s so far.
  double lowest_ = -1, highest_ = 0;  ///< Heights of the current stroke, m; negative: none.
  double rose_ = 0;                   ///< The most that the stroke has risen, m.
  double apart_ = 0;                  ///< s since the last contact with clay.
  double in_step_ = 0;                ///< s that the step has been shown.
  double looked_ = 0;                 ///< s since the outline was checked.
  std::size_t step_ = 0;              ///< Desk::lesson_step() at the last look.
};

}  // namespace onggi::screens
