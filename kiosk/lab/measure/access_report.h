#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

/// A display to measure.
struct AccessDisplay {
  int width = 0, height = 0;  ///< px
  double diagonal_mm = 0, distance_mm = 0;
};

/// Common kiosk displays, from a tablet's panel to 43 inches, landscape and portrait, each at its
/// usual viewing distance.
const std::vector<AccessDisplay>& likely_displays();

/// The figures of one screen, measured on its drawn picture.
struct ScreenAccess {
  std::string name;
  int texts = 0, controls = 0;
  double least_capital_mm = 0;        ///< Of its words: 0.714 of the em.
  double least_text_contrast = 0;     ///< Of all texts, against their background.
  std::string faintest;               ///< The text with that contrast.
  double least_control_contrast = 0;  ///< Of the marks of controls.
  double least_target_mm = 0;         ///< The shorter side of a control.
  std::string smallest;               ///< The control with that size.
  std::optional<int> flashes;         ///< The most in one second.
};

/// EN 301 549's figures of an exhibit on a display, as drawn on this machine.
struct AccessReport {
  AccessDisplay display;
  bool high_contrast = false;
  std::vector<ScreenAccess> screens;
  double warn_after = 0, countdown = 0;  ///< s
};

/// Walks through the exhibit's screens by their own controls, including help, Comfort and the
/// warning, on a stepped kiosk with its window open; first on the exhibit's own display, then on
/// `also`, where screens are drawn but not watched for flashes. Problem if a control is missing.
/// Blocks for some minutes.
Result<std::vector<AccessReport>> measure_access(exhibit::Kiosk& kiosk,
                                                 const std::vector<AccessDisplay>& also = {});

/// Height of a capital letter that appears at 0.7 degrees from `distance_mm`, mm.
double capital_asked(double distance_mm);

files::Json json_of(const AccessReport& report);
/// Screen by screen.
std::string text_of(const AccessReport& report);
/// A Markdown line for each display: the smallest figure of all its screens, and the screen.
/// Figures below the requirement are bold.
std::string table_of(const std::vector<AccessReport>& reports);

}  // namespace onggi::measure
