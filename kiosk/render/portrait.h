#pragma once

#include "engine/profile/mesh.h"
#include "kiosk/render/levels.h"
#include "kiosk/view/camera.h"

namespace onggi::render {

/// A mesh set up for its picture: what the stage needs to light and frame it.
struct Portrait {
  Mesh mesh;
  Levels levels;
  view::Camera camera;
};

/// Stands `mesh` on the ground with its bounding box over the origin; takes its outer and inner
/// radii at every level for the light; frames it in width x height with room for its shadow.
Portrait portrait_of(const TriangleMesh& mesh, int width, int height);

/// The radii of a mesh that stands on y = 0 about the y axis: the widest at every level, and the
/// widest that faces the axis (0 where none does).
Levels levels_of(const TriangleMesh& mesh);

}  // namespace onggi::render
