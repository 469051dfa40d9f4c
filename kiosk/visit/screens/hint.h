#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kiosk/visit/screens/desk.h"
#include "kiosk/wheel/device/wall_hold.h"

namespace onggi::screens {

/// How far a pot is that is built of coils.
struct BuiltPot {
  bool lacks_a_ring = false;
  bool to_beat = false;                ///< Its rings are laid, and its wall is still to be beaten;
  std::optional<Hint::Press> worst{};  ///< here most (with a paddle in the hand).
  bool beaten = false;                 ///< It was beaten, and has its vessel's height.
  bool wet = false;                    ///< Too wet to beat, and nothing dries it.
};

struct HintInput {
  const Profile* target = nullptr;
  const Profile* made = nullptr;
  const score::Score* score = nullptr;  ///< Of `made`, as the result would judge it.
  bool wheel_turns = true;
  device::Grip grip = device::Grip::both;
  bool touched = false;       ///< The visitor has touched this pot.
  bool dry_too_long = false;  ///< The clay was rubbed too long without water.
  double tool_radius = 0.008;
  std::optional<BuiltPot> built{};  ///< The pot is built of coils.
  bool coil_held = false, paddle_held = false;
  std::string tools_way{};  ///< Language key of the words on the button to the tools.
  std::string described{};  ///< The hint for wanted figures, if there is no outline to copy.
};

/// The most useful hint for the current state: of what the result would say to try next, the first
/// that hands can do now. Pure.
Hint next_hint(const HintInput& in);

/// Every hint in the desk's language, for reserving space.
std::vector<std::string> all_hints(const Desk& desk);
std::string words_of(const Hint& hint, const Desk& desk);

/// Shows one hint at a time: checks four times a second, and keeps each hint at least two seconds,
/// so that people can read it.
class HintLine {
 public:
  const Hint& update(double now, const HintInput& in);
  const Hint& shown() const { return shown_; }

 private:
  Hint shown_;
  double looked_ = -1, since_ = -10;
};

}  // namespace onggi::screens
