#pragma once

#include "engine/scene/coil_view.h"
#include "kiosk/picture/render/coil_mesh.h"
#include "kiosk/picture/render/outline.h"
#include "kiosk/picture/view/camera.h"

namespace onggi::render {

/// Adds the outlines of the coil that coil_mesh() draws: where its tube turns away from the eye.
/// `texel`: pixels of the frame in one of the picture. Allocates.
void add_coil_outline(Ribbons& ribbons, const CoilOnRim& coil, double turned, Opening opening,
                      const view::Camera& camera, float texel);

}  // namespace onggi::render
