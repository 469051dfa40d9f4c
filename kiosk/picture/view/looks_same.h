#pragma once

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// True if the two look the same on a screen, apart from the clay's shape: angles within 2e-4 rad,
/// places within 0.02 mm, wetness within two steps of 8 bits, everything else equal. Not
/// transitive: compare with the last drawn one, so that slow changes lead to a new picture.
bool looks_same(const PotView& drawn, const PotView& now);

}  // namespace onggi::view
