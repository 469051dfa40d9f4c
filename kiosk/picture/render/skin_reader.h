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

/// Reads off what the clay's surface is, by the shader that draws it: clay.glsl, told to write down
/// colour and roughness where it would light them. So what a pot is taken home with is what the
/// kiln has shown, and there is no second copy of any glaze.
class SkinReader {
 public:
  static Result<std::unique_ptr<SkinReader>> create();

  /// One for each of `pot`'s positions: of fired clay, or of dry clay. `set_up` makes a program
  /// ready that is in use: the clay's textures, its glaze.
  std::vector<view::SkinPoint> read(const ClayMesh& pot, bool fired,
                                    const std::function<void(const Program&)>& set_up) const;

 private:
  SkinReader() = default;
  static constexpr std::size_t kParts = 4;  // of clay.glsl: outer wall, lip, inner wall, floor
  std::array<std::array<Program, kParts>, 2> programs_;  // of dry clay, of fired
};

}  // namespace onggi::render
