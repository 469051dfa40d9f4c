#pragma once

#include <cstddef>
#include <vector>

#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// What the clay's surface is: dry, wet, glazed, or on its way to a glaze. Each has its own
/// programs, so that a pot without water or glaze is drawn without any of theirs.
class ClaySkin {
 public:
  static constexpr std::size_t kSkins = 4;  ///< SKIN of clay.glsl.

  /// Which of them `pot` needs.
  static std::size_t of(const view::PotView& pot);
  /// Before a pot is drawn: the water's rows go to the graphics side where there are any.
  void prepare(const view::PotView& pot);
  /// Colours and the rest, for a program of that skin, which is in use.
  void set(const Program& program, const view::PotView& pot, int texture_unit) const;

 private:
  Texture rows_;
  std::vector<float> wet_;  // as rows_ has it
};

}  // namespace onggi::render
