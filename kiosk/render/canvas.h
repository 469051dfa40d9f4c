#pragma once

#include <cstdint>

#include "kiosk/render/items.h"
#include "kiosk/render/stage.h"
#include "kiosk/view/frame.h"
#include "kiosk/view/image.h"

namespace onggi::render {

/// Where a whole frame is put together: plaster, the picture in space at its own scale, the items
/// at full resolution, and the fading picture of the screen before. Straight into the window's back
/// buffer where there is one, as every copy of a whole screen costs a machine without a GPU as much
/// as a tenth of the pot; else off screen.
class Canvas {
 public:
  /// What of a frame's picture in space is drawn: all of it, or nothing, where the one there is
  /// still looks the same.
  enum class Space : std::uint8_t { draw, keep };
  enum class Onto : std::uint8_t { window, own };
  /// Keeps the screen that was painted last for the fade, where `frame` is of another. Done by
  /// paint() too; before it, where pictures are to go in between.
  void turn_to(const view::Frame& frame, ItemPainter& items, const ItemPainter::Pictures& pictures);
  /// The window's back buffer must have the frame's size.
  void paint(Stage& stage, ItemPainter& items, const ItemPainter::Pictures& pictures,
             const view::Frame& frame, const Quality& quality, double scale, Onto onto,
             Space space = Space::draw);
  /// The frame that was painted last, onto the window's back buffer once more.
  void show(ItemPainter& items, const ItemPainter::Pictures& pictures);
  /// The frame that was painted last.
  view::Image read(ItemPainter& items, const ItemPainter::Pictures& pictures);

 private:
  void resize(int width, int height);
  void paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality, double scale);
  void compose(GLuint framebuffer, ItemPainter& items, const ItemPainter::Pictures& pictures);
  const Target& kept(Target& target) const;

  Target picture_, plaster_, before_, space_, space_samples_;
  int samples_ = -1;
  view::Frame frame_;  ///< As painted last,
  view::Rect reach_;   ///< and the part of it that is the picture in space.
  bool painted_ = false, has_before_ = false;
};

/// The part of a width x height frame that the pot, its wheel and their shadow can reach.
view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height);

}  // namespace onggi::render
