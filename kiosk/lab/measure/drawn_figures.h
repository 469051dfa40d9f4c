#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::measure {

/// Luminance contrast of two colours, 1 to 21, as in WCAG 2 (and EN 301 549).
double contrast(const std::uint8_t* one, const std::uint8_t* other);
/// Relative luminance of a pixel, 0 to 1, as in WCAG 2.
double luminance(const std::uint8_t* rgba);

/// Contrast of the marks inside `box` that are in `with` but not in `without`, each drawn pixel
/// against its background: the median of the tenth that differs most, because edges of letters are
/// mixed. 0 if nothing differs. Both pictures must have the same size.
double drawn_contrast(const view::Image& with, const view::Image& without, const view::Rect& box);

/// Counts flashes in a sequence of pictures: a tenth of luminance up and down again, or down and
/// up, the darker below 0.8 (WCAG 2.3.1). Each part of the screen as large as a quarter of 10
/// degrees of view is counted separately.
class FlashCount {
 public:
  /// `cell`: side of such a part, px.
  explicit FlashCount(int cell) : cell_(cell) {}
  void see(const view::Image& picture, double now);
  /// The most in any second, of any part.
  int most_in_a_second() const { return most_; }

 private:
  struct Part {
    double extreme = -1, last = -1;
    int direction = 0;
    /// Times at which luminance had changed by a tenth the other way, s.
    std::vector<double> changes;
  };
  int cell_;
  int most_ = 0;
  std::vector<Part> parts_;
};

}  // namespace onggi::measure
