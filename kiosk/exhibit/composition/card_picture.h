#pragma once

#include <memory>

#include "kiosk/collection/content/vessel.h"
#include "kiosk/picture/render/renderer.h"

namespace onggi::exhibit {

/// Draws vessels in the size of a card, each in two frames. In one a scan takes 0.6 s without a
/// GPU.
class CardPicture {
 public:
  /// Call once a frame with the same vessel until it returns its picture; 0: call it again. The
  /// renderer outlives this.
  view::PictureId next(render::Renderer& renderer, const content::Vessel& vessel);

 private:
  std::shared_ptr<const render::Portrait> prepared_;
  const content::Vessel* of_ = nullptr;
};

}  // namespace onggi::exhibit
