#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "kiosk/collection/content/language.h"
#include "kiosk/visit/screens/page.h"
#include "kiosk/visit/screens/visit_notes.h"

namespace onggi::screens {

/// What the visitor has before them, as plain values: what is said aloud, what a switch steps
/// through, and what a test reads, are these and nothing else.
struct Reading {
  ScreenId screen = ScreenId::attract;
  std::string over;                             ///< "help", "comfort", "idle", or nothing.
  const content::Language* language = nullptr;  ///< Outlives the visit.
  std::vector<std::string> words;  ///< What is written, from the top down, but for controls.
  std::vector<Control> controls;   ///< In the order in which they are read.
  std::string first;               ///< The control where a keyboard begins; may be none.
  std::string focus;               ///< The one that it is on; may be none.
  bool spoken = false, one_switch = false;  ///< As this visitor has chosen, or the screen is dark.
  bool unasked = false;  ///< It is spoken though nobody chose so: how to be read to is not told.
  double scan_seconds = 1.5;  ///< From one item of the switch to the next.

  /// At the wheel.
  bool working = false;                  ///< Hands are on the clay.
  int asked = 0;                         ///< How often it was asked where the pot differs,
  std::vector<std::string> differences;  ///< and where it does, in words, worst first.
};

}  // namespace onggi::screens
