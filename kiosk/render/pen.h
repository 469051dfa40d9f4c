#pragma once

#include <cairo.h>

#include <string>

#include "kiosk/view/frame.h"
#include "kiosk/view/image.h"

namespace onggi::render {

/// Draws on paper of its own with Cairo, and sets words with Pango: for pictures that are not on
/// the screen. Pixels from the top left. Needs no display. Allocates; any thread, one at a time.
class Pen {
 public:
  Pen() = default;
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// Takes a fresh sheet; once.
  void begin(int width, int height);
  void ink(view::Color color, double alpha = 1.0);
  void line(double x0, double y0, double x1, double y1, double width);
  /// Sets `words` at `px` a letter, broken at `width` (0: one line), and gives the height they
  /// take. `side`: -1 they end at x, 0 they stand about it, +1 they begin there.
  double words(const std::string& words, double x, double y, double px, int side, view::Color color,
               double width = 0, bool serif = false);
  /// Lays `image` down with its upper left corner at x, y.
  void picture(const view::Image& image, double x, double y);
  /// The sheet as it is now, opaque.
  view::Image image() const;

 protected:
  cairo_surface_t* surface_ = nullptr;
  cairo_t* c_ = nullptr;
};

}  // namespace onggi::render
