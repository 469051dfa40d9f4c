#pragma once

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Whether nobody could tell the two apart on a screen, the clay's shape left aside: angles within
/// 2e-4 rad, places within 0.02 mm, wetness within two steps of 8 bits, all else equal. Not
/// transitive: compare with what was last drawn, so that slow changes add up to a new picture.
bool looks_same(const PotView& drawn, const PotView& now);

}  // namespace onggi::view
