#pragma once

#include <array>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/collection/content/coloring.h"
#include "kiosk/picture/render/levels.h"
#include "kiosk/picture/view/camera.h"

namespace onggi::render {

/// A range of a mesh's indices with one picture.
struct Coat {
  Texture picture;  ///< sRGB.
  int first = 0, count = 0;
};

/// A mesh ready to draw, with the data that the stage needs to light it.
struct Model {
  Mesh mesh;  ///< Places, normals, linear colours, places in the picture.
  std::vector<Coat> coats;
  Levels levels;
  float radius = 0;  ///< Largest distance from the axis, including handles, m.
};

struct Portrait {
  Model model;
  view::Camera camera;
};

/// Prepares `mesh`, scaled by `size`, which stands on y = 0 about the y axis. Uses linear `color`,
/// or `coloring` of its positions if that is not empty.
Model model_of(const TriangleMesh& mesh, std::array<float, 3> color,
               const content::Coloring& coloring, float size);

/// Puts `mesh` on the ground with its bounding box over the origin and its largest side 0.2 m.
/// Computes its outer and inner radii at every level for the light. Frames it in width x height
/// with space for its shadow. Uses linear `color`, or `coloring` of its positions if that is not
/// empty.
Portrait portrait_of(const TriangleMesh& mesh, std::array<float, 3> color,
                     const content::Coloring& coloring, int width, int height);

/// The radii of a mesh that stands on y = 0 about the y axis, weighted by area: at every level the
/// mean outer wall, and the mean wall that faces the axis (0 if there is none). Needs normals.
Levels levels_of(const TriangleMesh& mesh);

}  // namespace onggi::render
