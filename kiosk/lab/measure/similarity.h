#pragma once

#include "kiosk/picture/view/image.h"
#include "kiosk/picture/view/rect.h"

namespace onggi::measure {

/// Mean structural similarity of the luma of two pictures of one size inside `within` (pixels; cut
/// to the pictures): 1 for equal pictures, lower if one looks blurred, jagged or shifted. Wang,
/// Bovik, Sheikh & Simoncelli 2004, with their Gaussian window of 11 x 11 and sigma 1.5, K1 0.01,
/// K2 0.03; windows that reach over the edge are left out. Luma is Rec. 709's of the display
/// values. 0 if the sizes differ or nothing is left to compare. Allocates; any thread.
double structural_similarity(const view::Image& a, const view::Image& b, const view::Rect& within);

}  // namespace onggi::measure
