#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/visit_notes.h"

namespace onggi::screens {

/// The content of the screen as plain values: speech, the one switch and tests read only this.
struct ScreenText {
  ScreenId screen = ScreenId::attract;
  std::string over;  ///< "help", "comfort", "languages", "idle", or empty.
  const content::Language* language = nullptr;  ///< Outlives the visit.
  std::vector<std::string> words;               ///< The text from the top down, without controls.
  std::vector<Control> controls;                ///< In reading order.
  std::string first;  ///< The control where a keyboard starts; may be empty.
  std::string focus;  ///< The control that has the keyboard; may be empty.
  /// The visitor's choices; `spoken` is also true if the screen is dark.
  bool spoken = false, one_switch = false;
  bool unasked = false;  ///< Speech is on although the visitor did not choose it, so its own help
                         ///< is not spoken.
  double scan_seconds = 1.5;  ///< Time for each item of the switch.

  /// At the wheel.
  bool working = false;                  ///< Hands touch the clay.
  int asked = 0;                         ///< How often the visitor asked where the pot differs,
  std::vector<std::string> differences;  ///< and the differences in words, worst first.
};

}  // namespace onggi::screens
