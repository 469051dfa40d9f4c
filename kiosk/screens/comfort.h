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
  static constexpr std::array<Choice, 6> kChoices{
      {{"left_handed", &settings::Exhibit::Screen::left_handed},
       {"low_reach", &settings::Exhibit::Screen::low_reach},
       {"larger_text", &settings::Exhibit::Screen::larger_text},
       {"high_contrast", &settings::Exhibit::Screen::high_contrast},
       {"reduced_motion", &settings::Exhibit::Screen::reduced_motion},
       {"silent", &settings::Exhibit::Screen::silent}}};

  /// `exhibit` with what was chosen in its place.
  settings::Exhibit::Screen applied(settings::Exhibit::Screen exhibit) const {
    for (std::size_t i = 0; i < kChoices.size(); ++i)
      if (chosen_[i]) exhibit.*kChoices[i].of = *chosen_[i];
    return exhibit;
  }
  /// Turns the choice that `control` names to its other state; false for other controls.
  bool press(const std::string& control, const settings::Exhibit::Screen& exhibit) {
    const settings::Exhibit::Screen now = applied(exhibit);
    for (std::size_t i = 0; i < kChoices.size(); ++i) {
      if (control != std::string("comfort.") + kChoices[i].name) continue;
      chosen_[i] = !(now.*kChoices[i].of);
      return true;
    }
    return false;
  }

 private:
  std::array<std::optional<bool>, kChoices.size()> chosen_{};
};

}  // namespace onggi::screens
