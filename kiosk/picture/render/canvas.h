#pragma once

#include <cstdint>
#include <optional>

#include "kiosk/picture/render/items.h"
#include "kiosk/picture/render/stage.h"
#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::render {

/// What a canvas draws with.
struct Painters {
  Stage& stage;
  ItemPainter& items;
  const ItemPainter::Pictures& pictures;
};

/// Composes a whole frame: plaster with the pot's shadow, the 3-D picture at its own scale, the
/// items at full resolution, and the fading picture of the previous screen. Draws straight into the
/// window's back buffer if there is one, else off screen: without a GPU, copying a whole screen
/// costs a tenth of drawing the pot. Before the items every pixel is written once: outside the 3-D
/// picture the ground is copied, inside it is drawn below the picture.
class Canvas {
 public:
  /// How much of a frame's 3-D picture is drawn: all, or nothing if the old one still looks the
  /// same.
  enum class Space : std::uint8_t { draw, keep };
  enum class Onto : std::uint8_t { window, own };
  /// Keeps the last painted screen for the fade, if `frame` shows another screen. paint() does this
  /// too; call it earlier if other pictures are painted in between.
  void turn_to(const view::Frame& frame, const Painters& with);
  /// Allocates a part of what the frame needs; true: there is more. Without a GPU it is most of a
  /// large picture's work at full quality, because the driver writes zeros to all of it.
  bool prepare(const Painters& with, const view::Frame& frame, const Quality& quality,
               double scale = 1.0);
  /// The window's back buffer must have the frame's size.
  void paint(const Painters& with, const view::Frame& frame, const Quality& quality, double scale,
             Onto onto, Space space = Space::draw);
  /// Copies the last painted frame to the window's back buffer again.
  void show(const Painters& with);
  /// The frame that was painted last.
  view::Image read(const Painters& with);

 private:
  void resize(int width, int height);
  void paint_plaster(const Painters& with, const view::Frame& frame);
  void make_space(const view::Frame& frame, const Quality& quality, double scale);
  void paint_pot(Stage& stage, const view::Frame& frame, const Quality& quality, double scale);
  /// The ground under `pot`, renewed if it has changed.
  void paint_ground(Stage& stage, const view::PotView& pot);
  void compose(GLuint framebuffer, const Painters& with);
  const Target& kept(Target& target) const;

  /// Everything that the ground's picture depends on.
  struct Ground {
    view::Camera camera;
    bool wheel = true;
    double window = 0;
    double opacity = 1;
    float foot = 0;
    Backdrop::Extent extent;
    std::uint64_t shadow = 0;
    std::optional<view::Camera> beside{};
    std::uint64_t its_shadow = 0;
    friend bool operator==(const Ground&, const Ground&) = default;
  };
  Target picture_, plaster_, before_, space_, ground_;
  BareDepths bare_;  // of space_
  std::optional<Ground> of_ground_;
  int samples_ = -1;
  view::Frame frame_;  ///< As last painted,
  view::Rect solid_;   ///< and its part with the 3-D picture.
  bool painted_ = false, has_before_ = false;
  double plaster_window_ = 0;
  bool composed_ = false;  ///< picture_ is the frame as last painted.
};

/// The part of a width x height frame that the pot, its wheel and held tools can reach, with or
/// without their shadow.
enum class Reach : std::uint8_t { solid, with_shadow };
view::Rect reach_of(const view::PotView& pot, double height, double radius, int width,
                    int frame_height, Reach reach = Reach::with_shadow);

}  // namespace onggi::render
