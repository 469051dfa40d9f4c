#pragma once

#include <string>

#include "kiosk/picture/view/frame.h"

namespace onggi::view {

/// Asks how large a text will be before it is laid out. Implemented by render with Pango.
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
