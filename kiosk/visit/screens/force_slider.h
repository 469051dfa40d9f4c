#pragma once

#include <string>
#include <vector>

#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

class Desk;

/// The share of the clay's force that a visitor feels: all, three quarters ... and off. Shown only
/// if a force device is plugged in. Each visitor starts with the exhibit's full force.
class ForceSlider {
 public:
  static constexpr int kSteps = 4;

  /// The visitor's share, 0 (off) .. 1.
  double share() const { return static_cast<double>(step_) / kSteps; }
  /// "throw.softer", the share, "throw.stronger"; empty if no device pushes.
  std::vector<Button> buttons(const Desk& desk) const;
  /// Handles a touch on one of them. False for other controls.
  bool press(const std::string& control);

 private:
  int step_ = kSteps;
};

}  // namespace onggi::screens
