#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "kiosk/picture/render/coil_mesh.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/mesh_outline.h"
#include "kiosk/picture/render/outline.h"

namespace onggi::render {

/// Depths of a picture in space as they were before its fingers were drawn. A finger fades, so that
/// edges behind it show.
struct BareDepths {
  Target target;       ///< As large as the picture; none before the first finger.
  glm::ivec4 part{0};  ///< Where it is filled, texels: left, low, right, high. Empty: no finger.
  void keep(const Target& space, glm::ivec4 around);  ///< Fills that part; binds `space`.
};

/// Smooth edges on a 3-D picture that is drawn with one sample a pixel, smaller than the frame.
/// Each outline is a narrow ribbon over the composed picture, at the frame's full size.
class Edges {
 public:
  static Result<std::unique_ptr<Edges>> create();

  /// Finds and uploads the outlines for a picture that is `scale` times the camera's size; `vessel`
  /// is the mesh of pot.beside; pot.coil is outside `opening`. Binds the target of the lip's strip,
  /// for draw_lip() with the program of the lip in clay.glsl.
  void prepare(const ClaySurface& clay, const CoatTexture& coat, const WallMesh& wall,
               const MeshEdges& vessel, Opening opening, const view::PotView& pot,
               const glm::mat4& clip, double scale);
  void draw_lip() const { lip_.draw(); }
  /// Draws them into the bound target, which shows `space` over `ground` and is a whole frame.
  void draw(const Target& space, const BareDepths& bare, const Texture& ground, float opacity,
            int width, int height);

 private:
  Edges() = default;
  std::array<Program, 2> programs_;  // of outlines, of creases
  Target strip_;
  Mesh lip_;
  ArrayName array_;
  BufferName corners_, indices_;
  std::size_t corner_room_ = 0, index_room_ = 0;
  Ribbons now_;
  std::vector<EdgeCorner> uploaded_corners_;
  std::vector<std::uint32_t> now_indices_, uploaded_indices_;
};

}  // namespace onggi::render
