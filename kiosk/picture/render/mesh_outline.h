#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "engine/profile/mesh.h"
#include "kiosk/picture/render/outline.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// The edges of a mesh with what lies beside them, so that a frame can find those where the mesh
/// turns away from the eye. Plain numbers.
struct MeshEdges {
  /// - border: only one triangle lies there;
  /// - unsure: its two triangles are not turned alike;
  /// - along, against: the first one's corners run from `a` to `b`, or from `b` to `a`, counter-
  ///   clockwise from outside the material.
  enum class Turned : std::uint8_t { border, unsure, along, against };
  struct Edge {
    std::uint32_t a = 0, b = 0;        ///< Its corners,
    std::uint32_t one = 0, other = 0;  ///< and those opposite to it in its two triangles.
    Turned turned = Turned::border;
  };
  std::vector<glm::vec3> corners;  ///< Metres, each place once.
  std::vector<Edge> edges;
};

/// Of the triangles of `mesh`, scaled by `size`. Corners at the same place are one, as at the seams
/// of a picture; a third triangle at an edge makes one more edge. Scans have triangles turned
/// either way, and whole ones turned inside out. Allocates; any thread; some 5 ms for 24,000
/// triangles.
MeshEdges edges_of(const TriangleMesh& mesh, float size);

/// Adds the outlines of the mesh of `edges` as `vessel` shows it: the outermost on each line of the
/// picture to both sides, and in each of its columns at the top and the bottom; and those within,
/// such as the near lip's before the inside, if they are longer than a few texels. Those that a
/// hollow hides from everywhere are left out. `texel`: pixels of the frame in one of the picture.
/// Allocates; any thread; a millisecond for 24,000 triangles.
void add_mesh_outline(Ribbons& ribbons, const MeshEdges& edges, const view::VesselView& vessel,
                      float texel);

}  // namespace onggi::render
