#pragma once

#include <string>

#include "engine/profile/mesh.h"

namespace onggi::console {

/// `section` seen from the side, as a small SVG: the outer wall, filled in a grey that stands on
/// light and on dark. "" where it has no height.
std::string side_view(const Section& section);

}  // namespace onggi::console
