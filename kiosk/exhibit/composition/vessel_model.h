#pragma once

#include "kiosk/picture/render/renderer.h"
#include "kiosk/visit/screens/visit.h"

namespace onggi::exhibit {

/// Shows `renderer` the vessel of `card` at the size in which it is thrown, to turn beside the pot,
/// with as few triangles as that takes (content::kTurningTriangles). Main thread.
void show_vessel(render::Renderer& renderer, const screens::ShelfCard& card);

}  // namespace onggi::exhibit
