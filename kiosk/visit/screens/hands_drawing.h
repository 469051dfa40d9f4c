#pragma once

#include "kiosk/collection/content/lesson.h"
#include "kiosk/visit/screens/page.h"

namespace onggi::screens {

/// A small line drawing of a pot in section with hands at it, like a potter's sketch, fitted into
/// `box`.
void draw_hands(Page& page, const view::Rect& box, content::HandsDrawn hands);

/// The same, with hands that press the wall inwards from outside, or outwards from inside.
void draw_pressing_hand(Page& page, const view::Rect& box, bool inward);

}  // namespace onggi::screens
