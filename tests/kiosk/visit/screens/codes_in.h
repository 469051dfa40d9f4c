#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/image.h"

namespace onggi::screens {

/// What a phone's scanner (zbar) finds in the whole picture, each code once.
std::vector<std::string> codes_in(const view::Image& image);

/// `image` as it is seen from a distance, `scale` times as large (a mean over what falls into a
/// pixel), and through a lens that is not sharp: a Gaussian of `sigma` pixels of what is seen.
view::Image seen_through(const view::Image& image, double scale, double sigma);

}  // namespace onggi::screens
