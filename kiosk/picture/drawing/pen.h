#pragma once

#include <cairo.h>

#include <cstddef>
#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::drawing {

/// The paper of sheets and plots.
inline constexpr view::Color kPaper{251 / 255.0f, 248 / 255.0f, 242 / 255.0f};

/// The style of words.
struct Lettering {
  double px = 24;  ///< Size of a letter.
  int side = 1;    ///< -1: they end at x, 0: they are centred on it, +1: they begin there.
  view::Color color{};
  double width = 0;    ///< Line width; 0: one line.
  int lines = 0;       ///< Most lines, the last one ending in "…"; 0: any number.
  bool serif = false;  ///< Like titles.
  double turn = 0;     ///< Radians, clockwise, around their position.
  double halo = 0;     ///< Pixels of paper around each letter, so that no line touches it.
};

/// Draws on its own paper with Cairo, and sets words with Pango, for pictures off the screen.
/// Pixels from the top left. Needs no display. Allocates; any thread, one at a time.
class Pen {
 public:
  Pen() = default;
  ~Pen();
  Pen(const Pen&) = delete;
  Pen& operator=(const Pen&) = delete;

  /// Takes a fresh sheet; once. `vector`: keeps lines and letters for svg().
  void begin(int width, int height, bool vector = false);
  void ink(view::Color color, double alpha = 1.0);
  void line(double x0, double y0, double x1, double y1, double width);
  /// Sets `words` with their upper edge at y; returns their height.
  double words(const std::string& words, double x, double y, const Lettering& how);
  /// The height of the words for words().
  double height_of(const std::string& words, const Lettering& how);
  /// Width of `words` on one line.
  double width_of(const std::string& words, const Lettering& how);
  /// Draws `image` with its upper left corner at x, y.
  void picture(const view::Image& image, double x, double y);
  /// The sheet so far, opaque.
  view::Image image() const;
  /// The same as the bytes of a PNG, or of an SVG for a vector sheet. Once, at the end.
  std::vector<std::byte> bytes();

 protected:
  cairo_surface_t* surface_ = nullptr;
  cairo_t* c_ = nullptr;

 private:
  std::vector<std::byte> written_;
  bool vector_ = false;
};

}  // namespace onggi::drawing
