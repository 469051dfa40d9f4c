#pragma once

#include "kiosk/collection/content/lesson.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// A small drawing of a pot in section and of the hands at it, in a line as a potter would draw it
/// on a slip of paper, fitted into `box`.
void draw_hands(Page& page, const view::Rect& box, content::HandsDrawn hands);

/// The same, hands that press the wall inwards from outside, or outwards from inside.
void draw_pressing_hand(Page& page, const view::Rect& box, bool inward);

}  // namespace onggi::screens
