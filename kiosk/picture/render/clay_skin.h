#pragma once

#include <cstddef>
#include <vector>

#include "kiosk/picture/render/gl.h"
#include "kiosk/picture/view/frame.h"

namespace onggi::render {

/// The clay's surface: dry, wet, glazed, or changing to a glaze. Each has its own programs, so that
/// a pot without water or glaze does not pay for them.
class ClaySkin {
 public:
  /// SKIN in clay.glsl.
  static constexpr std::size_t kDry = 0, kWet = 1, kGlazed = 2, kFiring = 3, kSkins = 4;

  static std::size_t of(const view::PotView& pot);
  /// Call before a pot is drawn: uploads the wetness of its rows, if it has any.
  void prepare(const view::PotView& pot);
  /// Sets colours and the other uniforms for the current program of that skin.
  void set(const Program& program, const view::PotView& pot, int texture_unit) const;

 private:
  Texture rows_;
  std::vector<float> wet_;  // as in rows_
};

}  // namespace onggi::render
