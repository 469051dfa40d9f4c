#pragma once

#include <functional>
#include <memory>

#include "engine/base/result.h"
#include "kiosk/picture/render/coil_mesh.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// Draws the coil that lies on the rim and is not closed to a ring yet: clay that has no rows.
class CoilPainter {
 public:
  static Result<std::unique_ptr<CoilPainter>> create();

  /// Call before the others. `opening`: of the pot in this picture.
  void prepare(const view::PotView& pot, Opening opening);
  /// `rim`: height of the clay below it, m. `light` sets the uniforms of light.glsl and the clay's
  /// colours. Draws into the bound target, with depth. Nothing if no coil lies there.
  void draw(const view::PotView& pot, float rim, const glm::mat4& clip,
            const std::function<void(const Program&)>& light) const;

 private:
  CoilPainter() = default;
  Program program_;
  TriangleMesh mesh_;
};

}  // namespace onggi::render
