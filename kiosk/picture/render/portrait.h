#pragma once

#include <array>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/picture/render/levels.h"
#include "kiosk/picture/view/camera.h"

namespace onggi::render {

/// A run of a mesh's indices that one picture lies on.
struct Coat {
  Texture picture;  ///< sRGB.
  int first = 0, count = 0;
};

/// A mesh set up to be drawn: what the stage needs to light it.
struct Model {
  Mesh mesh;  ///< Places, normals, linear colours, places in the picture.
  std::vector<Coat> coats;
  Levels levels;
  float radius = 0;  ///< Of what reaches farthest from the axis, handles too, m.
};

/// A model and how its picture is taken.
struct Portrait {
  Model model;
  view::Camera camera;
};

/// Sets up `mesh`, which stands on y = 0 about the y axis, times `size`. Linear `color` all over,
/// or, where it is not empty, `coloring` of its positions.
Model model_of(const TriangleMesh& mesh, std::array<float, 3> color,
               const content::Coloring& coloring, float size);

/// Stands `mesh` on the ground with its bounding box over the origin, 0.2 m in its largest side;
/// takes its outer and inner radii at every level for the light; frames it in width x height with
/// room for its shadow. Linear `color` all over, or, where it is not empty, `coloring` of its
/// positions.
Portrait portrait_of(const TriangleMesh& mesh, std::array<float, 3> color,
                     const content::Coloring& coloring, int width, int height);

/// The radii of a mesh that stands on y = 0 about the y axis, by area: mean outer wall at every
/// level, and mean wall that faces the axis (0 where none does). Needs normals.
Levels levels_of(const TriangleMesh& mesh);

}  // namespace onggi::render
