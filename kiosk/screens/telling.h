#pragma once

#include "kiosk/screens/show_me.h"

namespace onggi::screens {

/// The one sentence beside the pot and the small drawing of the hands that goes with it: news of a
/// fault or a device before what is being shown, before the lesson's step, before the hint. The
/// room that the longest sentence takes is kept, so that no control moves under a finger.
void lay_out_telling(Column& column, const Desk& desk, const ShowMe& show, const Hint& hint);

}  // namespace onggi::screens
