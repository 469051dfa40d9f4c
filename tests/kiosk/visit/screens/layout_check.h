#pragma once

#include "tests/kiosk/visit/screens/visitor.h"

namespace onggi::screens {

/// Fails where, in the visitor's present frame, words are cut or reach beyond the screen, two words
/// or two controls or a word and a picture overlap, a control stands in the shadow of a pot or is
/// too small for a finger, or words have capitals of less than 0.7 degrees.
void check_layout(const Visitor& visitor, const view::TextMeasure& measure,
                  const std::string& name);

}  // namespace onggi::screens
