#pragma once

#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// Gives `renderer` the vessel of `card` at its size on the wheel, to turn beside the pot, with few
/// triangles (content::kTurningTriangles). Main thread.
void show_vessel(render::Renderer& renderer, const screens::ShelfCard& card);

}  // namespace onggi::exhibit
