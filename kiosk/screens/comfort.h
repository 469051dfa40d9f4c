#pragma once

#include <array>
#include <optional>
#include <string>

#include "kiosk/settings/exhibit.h"

namespace onggi::screens {

/// What a visitor has chosen of how the exhibit is shown, for this visit: each as the exhibit has
/// it until it is chosen otherwise.
class Comfort {
 public:
  struct Choice {
    const char* name;  ///< Control "comfort.NAME"; words "comfort.NAME" and "comfort.NAME_is".
    bool settings::Exhibit::Screen::*of;
  };
  static constexpr std::array<Choice, 5> kChoices{
      {{"left_handed", &settings::Exhibit::Screen::left_handed},
       {"low_reach", &settings::Exhibit::Screen::low_reach},
       {"larger_text", &settings::Exhibit::Screen::larger_text},
       {"high_contrast", &settings::Exhibit::Screen::high_contrast},
       {"reduced_motion", &settings::Exhibit::Screen::reduced_motion}}};
  /// Controls "comfort.volume.0" (silent) .. of all that the exhibit allows.
  static constexpr int kLoudest = 4;

  /// `exhibit` with what was chosen in its place.
  settings::Exhibit::Screen applied(settings::Exhibit::Screen exhibit) const {
    for (std::size_t i = 0; i < kChoices.size(); ++i)
      if (chosen_[i]) exhibit.*kChoices[i].of = *chosen_[i];
    if (volume_) exhibit.silent = *volume_ == 0;
    return exhibit;
  }
  /// How loud, 0..kLoudest: all, unless the exhibit is silent as it comes.
  int volume(const settings::Exhibit::Screen& exhibit) const {
    return volume_.value_or(exhibit.silent ? 0 : kLoudest);
  }
  static std::string volume_control(int step) { return "comfort.volume." + std::to_string(step); }
  /// Turns the choice that `control` names to its other state, or the volume to a step of it; false
  /// for other controls.
  bool press(const std::string& control, const settings::Exhibit::Screen& exhibit) {
    const settings::Exhibit::Screen now = applied(exhibit);
    for (std::size_t i = 0; i < kChoices.size(); ++i) {
      if (control != std::string("comfort.") + kChoices[i].name) continue;
      chosen_[i] = !(now.*kChoices[i].of);
      return true;
    }
    for (int step = 0; step <= kLoudest; ++step)
      if (control == volume_control(step)) {
        volume_ = step;
        return true;
      }
    return false;
  }

 private:
  std::array<std::optional<bool>, kChoices.size()> chosen_{};
  std::optional<int> volume_;
};

}  // namespace onggi::screens
