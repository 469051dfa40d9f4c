#pragma once

#include <string>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Measures text before layout. Implemented by render with Pango.
class TextMeasure {
 public:
  virtual ~TextMeasure() = default;
  struct Size {
    float width = 0, height = 0;
  };
  /// Size of `text` set in lines of at most `width` pixels (<= 0: one line).
  virtual Size measure(const std::string& text, const TextStyle& style, float width) const = 0;
};

}  // namespace onggi::view
