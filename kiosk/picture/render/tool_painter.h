#pragma once

#include <functional>
#include <memory>

#include "engine/base/result.h"
#include "engine/scene/hand_view.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/levels.h"

namespace onggi::render {

/// Draws what a hand holds: the working body where the engine has it, to its very size, and what
/// tells its nature (the finger that goes on into the air, handles, wood, steel, sponge).
class ToolPainter {
 public:
  static Result<std::unique_ptr<ToolPainter>> create();

  /// `light` sets what light.glsl wants; `levels` of the clay say on which side of the wall a ball
  /// is. Into the bound target, premultiplied, with depth.
  void draw(const HandView& hand, const Levels& levels, const glm::mat4& clip,
            const std::function<void(const Program&)>& light) const;
  /// Nothing that is drawn of `hand` is farther from hand.at, metres.
  static double reach(const HandView& hand);

 private:
  ToolPainter() = default;
  Program program_;
  Mesh capsule_, box_, drum_, ring_;
};

}  // namespace onggi::render
