#pragma once

#include "kiosk/visit/screens/show_me.h"

namespace onggi::screens {

/// The one sentence beside the pot and the small drawing of the hands that goes with it: news of a
/// fault or a device before what is being shown, before the lesson's step, before the hint. The
/// room that the longest sentence takes is kept, so that no control moves under a finger.
void lay_out_telling(Column& column, const Desk& desk, const ShowMe& show, const Hint& hint);

/// How high the longest of those sentences is, `width` pixels wide.
float longest_telling(const Page& page, const Desk& desk, float width);
/// What of the words' width the drawing takes: upright it stands beside the sentence.
float telling_drawing(const Page& page);
/// And of the room under the sentence, at the least, across.
float telling_below(const Page& page);

}  // namespace onggi::screens
