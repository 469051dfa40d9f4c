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

/// Stands `mesh` on the ground with its bounding box over the origin, 0.2 m in its largest side;
/// takes its outer and inner radii at every level for the light; frames it in width x height with
/// room for its shadow.
Portrait portrait_of(const TriangleMesh& mesh, int width, int height);

/// The radii of a mesh that stands on y = 0 about the y axis, by area: mean outer wall at every
/// level, and mean wall that faces the axis (0 where none does). Needs normals.
Levels levels_of(const TriangleMesh& mesh);

}  // namespace onggi::render
