#pragma once

#include <optional>
#include <string>
#include <vector>

#include "kiosk/exhibit/composition/kiosk.h"
#include "kiosk/ground/files/json.h"

namespace onggi::measure {

/// A display that figures are measured for.
struct AccessDisplay {
  int width = 0, height = 0;  ///< px
  double diagonal_mm = 0, distance_mm = 0;
};

/// What a kiosk is likely to have: from a tablet's panel to one of 43 inches, across and upright,
/// each seen from where one stands before it.
const std::vector<AccessDisplay>& likely_displays();

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
  std::optional<int> flashes;         ///< The most in a second, while it was looked at.
};

/// EN 301 549's figures of an exhibit on a display, as it is drawn on this machine.
struct AccessReport {
  AccessDisplay display;
  bool high_contrast = false;
  std::vector<ScreenAccess> screens;
  double warn_after = 0, countdown = 0;  ///< s
};

/// Walks through the exhibit's screens by their own controls, help, Comfort and the warning too, on
/// a stepped kiosk with its window open; first the exhibit's own display, then `also`, on which
/// each screen is laid out and drawn too, but not watched for flashes. Problem where a control is
/// missing. Blocks for some minutes.
Result<std::vector<AccessReport>> measure_access(exhibit::Kiosk& kiosk,
                                                 const std::vector<AccessDisplay>& also = {});

/// Height of a capital that is seen at 0.7 degrees from `distance_mm`, mm.
double capital_asked(double distance_mm);

files::Json json_of(const AccessReport& report);
/// Screen by screen.
std::string text_of(const AccessReport& report);
/// A line a display, in Markdown: the least of all its screens, and on which. What is short of what
/// is asked stands in bold.
std::string table_of(const std::vector<AccessReport>& reports);
/// `page` with `table` in place of what stands between the two comments that say where it belongs.
/// Problem where they are not there.
Result<std::string> with_table(const std::string& page, const std::string& table);

}  // namespace onggi::measure
