#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "kiosk/picture/view/measure.h"

namespace onggi::souvenir {

/// Half an em a byte, broken anywhere: crude, and wider than any font.
class WideMeasure final : public view::TextMeasure {
 public:
  Size measure(const std::string& text, const view::TextStyle& style, float width) const override {
    Size size;
    std::size_t begin = 0;
    while (begin <= text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      const float line = static_cast<float>(end - begin) * style.px * 0.5f;
      const float lines = width > 0 ? std::max(1.0f, std::ceil(line / width)) : 1.0f;
      size.width = std::max(size.width, width > 0 ? std::min(line, width) : line);
      size.height += lines * style.px * style.line_height;
      begin = end + 1;
    }
    return size;
  }
};

}  // namespace onggi::souvenir
