#pragma once

#include "kiosk/picture/view/image.h"
#include "kiosk/picture/view/rect.h"

namespace onggi::measure {

/// Mean structural similarity of the luma of two pictures of one size inside `within` (pixels; cut
/// to the pictures): 1 the same, lower the more blurred, jagged or shifted one is to the eye. Wang,
/// Bovik, Sheikh & Simoncelli 2004, with their Gaussian window of 11 x 11 and sigma 1.5, K1 0.01,
/// K2 0.03; windows that would reach over the edge are left out. Luma is Rec. 709's of the display
/// values. 1 where the sizes differ or nothing is left to compare is never said: then it is 0.
/// Allocates; any thread.
double structural_similarity(const view::Image& a, const view::Image& b, const view::Rect& within);

}  // namespace onggi::measure
