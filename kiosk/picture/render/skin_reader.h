#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "engine/base/result.h"
#include "engine/clay/clay_mesh.h"
#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/view/skin_point.h"

namespace onggi::render {

/// Reads the clay's surface with the shader that draws it: clay.glsl in a mode that writes colour
/// and roughness, without light. So the keepsake's pot matches the kiln screen, and the glaze
/// exists only once.
class SkinReader {
 public:
  static Result<std::unique_ptr<SkinReader>> create();

  /// One for each of `pot`'s positions: fired or dry clay. `set_up` prepares the current program:
  /// the clay's textures, its glaze.
  std::vector<view::SkinPoint> read(const ClayMesh& pot, bool fired,
                                    const std::function<void(const Program&)>& set_up) const;

 private:
  SkinReader() = default;
  static constexpr std::size_t kParts = 4;  // of clay.glsl: outer wall, lip, inner wall, floor
  std::array<std::array<Program, kParts>, 2> programs_;  // of dry clay, of fired
};

}  // namespace onggi::render
