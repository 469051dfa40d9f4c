#include "kiosk/exhibit/composition/card_picture.h"

namespace onggi::exhibit {
namespace {

constexpr int kCardWidth = 480, kCardHeight = 600;

}  // namespace

view::PictureId CardPicture::next(render::Renderer& renderer, const content::Vessel& vessel) {
  if (!prepared_ || of_ != &vessel) {
    of_ = &vessel;
    prepared_ = renderer.prepare_picture(vessel.mesh, vessel.color, vessel.coloring, kCardWidth,
                                         kCardHeight);
    return 0;
  }
  const view::PictureId drawn = renderer.draw_picture(*prepared_);
  prepared_.reset();
  return drawn;
}

}  // namespace onggi::exhibit
