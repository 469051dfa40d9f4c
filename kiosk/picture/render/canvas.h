#pragma once

#include <cstdint>
#include <optional>

#include "kiosk/picture/render/items.h"
#include "kiosk/picture/render/stage.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::render {

/// What a canvas paints with.
struct Painters {
  Stage& stage;
  ItemPainter& items;
  const ItemPainter::Pictures& pictures;
};

/// Where a whole frame is put together: plaster with the pot's shadow, the picture in space at its
/// own scale, the items at full resolution, and the fading picture of the screen before. Straight
/// into the window's back buffer where there is one, as every copy of a whole screen costs a
/// machine without a GPU as much as a tenth of the pot; else off screen. Every pixel of it is
/// written once before the items: the ground is copied where the picture in space is not, and drawn
/// under it where it is.
class Canvas {
 public:
  /// What of a frame's picture in space is drawn: all of it, or nothing, where the one there is
  /// still looks the same.
  enum class Space : std::uint8_t { draw, keep };
  enum class Onto : std::uint8_t { window, own };
  /// Keeps the screen that was painted last for the fade, where `frame` is of another. Done by
  /// paint() too; before it, where pictures are to go in between.
  void turn_to(const view::Frame& frame, const Painters& with);
  /// The window's back buffer must have the frame's size.
  void paint(const Painters& with, const view::Frame& frame, const Quality& quality, double scale,
             Onto onto, Space space = Space::draw);
  /// The frame that was painted last, onto the window's back buffer once more.
  void show(const Painters& with);
  /// The frame that was painted last.
  view::Image read(const Painters& with);

 private:
  void resize(int width, int height);
  void paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality, double scale);
  /// The ground under `pot`, anew where it has changed.
  void paint_ground(Stage& stage, const view::PotView& pot);
  void compose(GLuint framebuffer, const Painters& with);
  const Target& kept(Target& target) const;

  /// What the ground's picture was drawn from.
  struct Ground {
    view::Camera camera;
    bool wheel = true, window_right = false;
    double opacity = 1;
    float foot = 0;
    Backdrop::Extent extent;
    std::uint64_t shadow = 0;
    std::optional<view::Camera> beside{};
    std::uint64_t its_shadow = 0;
    friend bool operator==(const Ground&, const Ground&) = default;
  };
  Target picture_, plaster_, before_, space_, ground_;
  std::optional<Ground> of_ground_;
  int samples_ = -1;
  view::Frame frame_;  ///< As painted last,
  view::Rect solid_;   ///< and the part of it that is the picture in space.
  bool painted_ = false, has_before_ = false, plaster_right_ = false;
};

/// The part of a width x height frame that the pot, its wheel and what hands hold can reach, with
/// their shadow or without.
enum class Reach : std::uint8_t { solid, with_shadow };
view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height, Reach reach = Reach::with_shadow);

}  // namespace onggi::render
