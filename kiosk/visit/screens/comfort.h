#pragma once

#include <array>
#include <optional>
#include <string>

#include "kiosk/collection/settings/exhibit.h"

namespace onggi::screens {

/// The visitor's display choices for this visit; each starts as the exhibit has it.
class Comfort {
 public:
  struct Choice {
    /// Control "comfort.NAME"; language keys "comfort.NAME" and "comfort.NAME_is".
    const char* name;
    bool settings::Exhibit::Screen::*of;
  };
  static constexpr std::array<Choice, 7> kChoices{
      {{"left_handed", &settings::Exhibit::Screen::left_handed},
       {"low_reach", &settings::Exhibit::Screen::low_reach},
       {"larger_text", &settings::Exhibit::Screen::larger_text},
       {"high_contrast", &settings::Exhibit::Screen::high_contrast},
       {"reduced_motion", &settings::Exhibit::Screen::reduced_motion},
       {"spoken", &settings::Exhibit::Screen::spoken},
       {"one_switch", &settings::Exhibit::Screen::one_switch}}};
  /// Controls "comfort.volume.0" (silent) up to the exhibit's full volume.
  static constexpr int kLoudest = 4;

  settings::Exhibit::Screen applied(settings::Exhibit::Screen exhibit) const {
    for (std::size_t i = 0; i < kChoices.size(); ++i)
      if (chosen_[i]) exhibit.*kChoices[i].of = *chosen_[i];
    if (volume_) exhibit.silent = *volume_ == 0;
    if (pace_ > 0) exhibit.scan_seconds = pace_;
    return exhibit;
  }
  /// Volume step, 0..kLoudest; kLoudest unless the exhibit starts silent.
  int volume(const settings::Exhibit::Screen& exhibit) const {
    return volume_.value_or(exhibit.silent ? 0 : kLoudest);
  }
  static std::string volume_control(int step) { return "comfort.volume." + std::to_string(step); }
  /// Switches the choice named by `control`, or sets the volume's step; false for other controls.
  bool press(const std::string& control, const settings::Exhibit::Screen& exhibit) {
    const settings::Exhibit::Screen now = applied(exhibit);
    for (const double way : {-1.0, 1.0})
      if (control == (way < 0 ? kFaster : kSlower)) {
        pace_ = next_pace(now.scan_seconds, way);
        return true;
      }
    for (std::size_t i = 0; i < kChoices.size(); ++i) {
      if (control != std::string("comfort.") + kChoices[i].name) continue;
      chosen_[i] = !(now.*kChoices[i].of);
      last_ = kChoices[i].name;
      return true;
    }
    for (int step = 0; step <= kLoudest; ++step)
      if (control == volume_control(step)) {
        volume_ = step;
        return true;
      }
    return false;
  }

  /// Choice::name of the choice that was switched last; null: none was.
  const char* last() const { return last_; }

  static constexpr const char *kFaster = "comfort.faster", *kSlower = "comfort.slower";
  /// The switch speeds to choose from, s.
  static constexpr std::array<double, 8> kPaces{0.5, 0.7, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0};

 private:
  static double next_pace(double now, double way) {
    double best = now;
    for (const double pace : kPaces)
      if ((pace - now) * way > 1e-6 && (best == now || (pace - best) * way < 0)) best = pace;
    return best;
  }
  double pace_ = 0;  ///< 0: the exhibit's value.
  std::array<std::optional<bool>, kChoices.size()> chosen_{};
  std::optional<int> volume_;
  const char* last_ = nullptr;
};

}  // namespace onggi::screens
