#pragma once

#include <functional>
#include <memory>

#include "engine/base/result.h"
#include "engine/scene/hand_view.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/render/levels.h"

namespace onggi::render {

/// The direction in which a finger extends from its ball, unit: upwards and outwards if it works
/// the outer wall; within the pot upwards, and inwards as far as the wall above asks for it.
glm::vec3 finger_lean(const HandView& hand, const Levels& levels);

/// Draws the held tool: its working body at the engine's place and in exact size, and the parts
/// that show its kind (the finger that fades into the air, handles, wood, steel, sponge).
class ToolPainter {
 public:
  static Result<std::unique_ptr<ToolPainter>> create();

  /// `light` sets the uniforms of light.glsl. The clay's `levels` tell on which side of the wall a
  /// ball is. Draws into the bound target, premultiplied, with depth.
  void draw(const HandView& hand, const Levels& levels, const glm::mat4& clip,
            const std::function<void(const Program&)>& light) const;
  /// True of a finger: what lies behind it shows through, more and more along it.
  static bool fades(const HandView& hand);
  /// Largest distance of any drawn part of `hand` from hand.at, metres.
  static double reach(const HandView& hand);

 private:
  ToolPainter() = default;
  Program program_;
  Mesh capsule_, box_, drum_, ring_;
};

}  // namespace onggi::render
