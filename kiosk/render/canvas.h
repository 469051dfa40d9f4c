#pragma once

#include "kiosk/render/items.h"
#include "kiosk/render/stage.h"
#include "kiosk/view/frame.h"
#include "kiosk/view/image.h"

namespace onggi::render {

/// Where a whole frame is put together, off screen: plaster, the picture in space at its own scale,
/// the items at full resolution, and the fading picture of the screen before.
class Canvas {
 public:
  void paint(Stage& stage, ItemPainter& items, const ItemPainter::Pictures& pictures,
             const view::Frame& frame, const Quality& quality, double scale);
  /// Copies the picture to the window's back buffer.
  void show(int width, int height) const;
  /// The picture as painted.
  view::Image read() const;

 private:
  void resize(int width, int height);
  void paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality, double scale);

  Target picture_, plaster_, before_, space_, space_samples_;
  int samples_ = -1;
  std::uint64_t serial_ = 0;
  bool painted_ = false, has_before_ = false;
};

/// The part of a width x height frame that the pot, its wheel and their shadow can reach.
view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height);

}  // namespace onggi::render
