#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

class Desk;

/// How much of the clay's force a visitor would feel: all, three quarters ... and off. Only where a
/// device that pushes is plugged in. Each visitor begins with all of what the exhibit allows.
class ForceSlider {
 public:
  static constexpr int kSteps = 4;

  /// The visitor's share, 0 (off) .. 1.
  double share() const { return static_cast<double>(step_) / kSteps; }
  /// "throw.softer", how much, "throw.stronger"; empty where no device pushes.
  std::vector<Button> buttons(const Desk& desk) const;
  /// A touch on one of them. False for any other control.
  bool press(const std::string& control);

 private:
  int step_ = kSteps;
};

}  // namespace onggi::screens
