#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include "kiosk/picture/render/mask_atlas.h"
#include "kiosk/picture/view/measure.h"

namespace onggi::render {

/// Sets paragraphs with Pango: any script, also right to left, with the language's line breaks and
/// tabular figures. Measuring and drawing use the same layout. Caches its results, and drops the
/// least used pages first. Main thread.
class Typesetter final : public view::TextMeasure {
 public:
  /// A longer paragraph is cut there with an ellipsis; 13 ms at most in narrow lines.
  static constexpr std::size_t kMostBytes = 4096;

  Typesetter();
  ~Typesetter() override;

  Size measure(const std::string& text, const view::TextStyle& style, float width) const override;

  /// A paragraph as a coverage mask, as small as its ink. x, y: where to draw it in its box.
  struct Block {
    MaskAtlas::Place mask;
    int x = 0, y = 0, w = 0, h = 0;  ///< Pixels; w 0: there is no ink.
    float width = 0;                 ///< Width of the set text.
    float height = 0;
  };
  /// Valid until the next call; its mask until masks().end_of_use().
  const Block& set(const std::string& text, const view::TextStyle& style, float width);
  MaskAtlas& masks() { return masks_; }

 private:
  struct Pango;
  std::unique_ptr<Pango> pango_;
  MaskAtlas masks_;
  std::unordered_map<std::string, Block> blocks_;
  mutable std::unordered_map<std::string, Size> sizes_;
};

}  // namespace onggi::render
