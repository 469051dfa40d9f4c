#pragma once

#include <string>
#include <vector>

#include "kiosk/exhibit/kiosk.h"
#include "kiosk/files/json.h"

namespace onggi::measure {

/// What one screen comes to, measured on the picture that was drawn of it.
struct ScreenAccess {
  std::string name;
  int texts = 0, controls = 0;
  double least_capital_mm = 0;        ///< Of its words: 0.714 of the letter's body.
  double least_text_contrast = 0;     ///< Of every text, to 1 what is behind it.
  std::string faintest;               ///< That text.
  double least_control_contrast = 0;  ///< Of what shows where a control is.
  double least_target_mm = 0;         ///< The shorter side of a control.
  std::string smallest;               ///< That control.
  int flashes = 0;                    ///< The most in a second, while it was looked at.
};

/// EN 301 549's figures of an exhibit on a screen, as it is drawn on this machine.
struct AccessReport {
  int width = 0, height = 0;
  double diagonal_mm = 0, distance_mm = 0;
  bool high_contrast = false;
  std::vector<ScreenAccess> screens;
  double warn_after = 0, countdown = 0;  ///< s
};

/// Walks through the exhibit's screens by their own controls, help, Comfort and the warning too, on
/// a stepped kiosk with its window open. Problem where a control is missing. Blocks for some
/// minutes.
Result<AccessReport> measure_access(exhibit::Kiosk& kiosk);

files::Json json_of(const AccessReport& report);
std::string text_of(const AccessReport& report);

}  // namespace onggi::measure
