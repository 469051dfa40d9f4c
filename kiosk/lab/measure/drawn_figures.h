#pragma once

#include <string>
#include <vector>

#include "kiosk/picture/view/frame.h"
#include "kiosk/picture/view/image.h"

namespace onggi::measure {

/// How two colours differ in luminance, 1 to 21, as WCAG 2 has it (and EN 301 549 by it).
double contrast(const std::uint8_t* one, const std::uint8_t* other);
/// Relative luminance of a pixel, 0 to 1, likewise.
double luminance(const std::uint8_t* rgba);

/// Contrast of what `with` has inside `box` and `without` has not, each drawn pixel against what
/// was behind it: the median of the tenth that differs most, since the edges of letters are half of
/// one and half of the other. 0 where nothing differs. Both of one size.
double drawn_contrast(const view::Image& with, const view::Image& without, const view::Rect& box);

/// Counts flashes in pictures that follow each other: a tenth of luminance up and down again, or
/// down and up, the darker below 0.8 (WCAG 2.3.1). Each part of the screen that is as large as a
/// quarter of 10 degrees of view is counted by itself.
class FlashCount {
 public:
  /// `cell`: px of a side of such a part.
  explicit FlashCount(int cell) : cell_(cell) {}
  void see(const view::Image& picture, double now);
  /// The most in any second, of any part.
  int most_in_a_second() const { return most_; }

 private:
  struct Part {
    double extreme = -1, last = -1;
    int direction = 0;
    std::vector<double> changes;  ///< When luminance had changed by a tenth the other way, s.
  };
  int cell_;
  int most_ = 0;
  std::vector<Part> parts_;
};

}  // namespace onggi::measure
